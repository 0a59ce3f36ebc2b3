#pragma once
// The parts of the viewport's bar, and the lists behind them: each draws at the cursor.
#include <imgui.h>

#include <string>
#include <vector>

#include "editor/picture/display_mode.h"
#include "nodes/declare/node_type.h"
#include "renderer/view/display.h"

namespace pileus::editor {

struct ViewportRoom;

/// What the parts of the bar work on.
struct Bar {
  const ViewportRoom& room;
  const std::string& view;  ///< the node whose parameters count
  const nodes::NodeType& type;
  view::DisplaySettings settings;
  std::vector<std::string> outputs;
  std::vector<LayerChoice> layers;
  std::size_t layer = 0;
};

void listOutputs(Bar& bar);
void listLayers(Bar& bar);
void listChannels(Bar& bar);
void listDisplays(Bar& bar);
void listViews(Bar& bar);
void listLooks(Bar& bar);
void listResolutions(Bar& bar);
void listDraftTimes(Bar& bar);
/// The view transform's name, the default's too.
std::string shownViewTransform(const Bar& bar);

void drawOutput(Bar& bar);
void drawLayer(Bar& bar);
void drawChannel(Bar& bar);
void drawDisplay(Bar& bar);
void drawView(Bar& bar);
void drawLook(Bar& bar);
void drawResolution(Bar& bar);
void drawExposure(Bar& bar);
void drawGamma(Bar& bar);
void drawCamera(Bar& bar);
bool hasCamera(const Bar& bar);  ///< a linked one, that can be locked
/// A number of the view node, to drag or type; a right click resets it.
void dragNumber(Bar& bar, const char* param, double value, const char* unit, const char* label,
                const char* help, float width);

// Buttons, as wide as high.
void drawLock(Bar& bar);
void drawRaw(Bar& bar);
void drawFalse(Bar& bar);
void drawZebra(Bar& bar);
void drawInspect(Bar& bar);
void drawHisto(Bar& bar);
void drawHudButton(Bar& bar);
void drawRegionButton(Bar& bar);
void drawStill(Bar& bar);
void drawCompareButton(Bar& bar);

}  // namespace pileus::editor
