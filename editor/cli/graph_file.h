#pragma once
// What the subcommands that work on graph files share: reading one without errors, and how its pictures are
// displayed.
#include <filesystem>
#include <memory>
#include <string>

#include "nodes/file/serialize.h"
#include "renderer/image/color.h"

namespace pileus::cli {

/// Faults are printed; any error among them ends it: "FILE: not `what` because of the errors above". Errors:
/// Input.
Result<nodes::Graph> loadFaultless(const std::filesystem::path& file, const char* what);

/// The same of a graph that was read already.
Result<nodes::Graph> withoutFaults(Result<nodes::Loaded> loaded, const std::filesystem::path& file,
                                   const char* what);

/// The output node that is meant: `wanted`, or the only one, an EXR output before a view. Error (Arguments):
/// no such node, or several; Error (Input): none at all.
Result<std::string> outputNode(const nodes::Graph& graph, const std::filesystem::path& file,
                               const std::string& wanted);

/// Of a view node; the configuration's defaults without one.
struct DisplayChoice {
  std::string display, view;  ///< "" = the configuration's default
  double exposure = 0;        ///< stops
  std::string look;
  double gamma = 1;
};
/// By `preferred`, if that is a view node, else by the file's last one.
DisplayChoice displayOf(const nodes::Graph& graph, const std::string& preferred = {});

/// The graph's colour configuration; relative paths start at `folder`.
Result<std::shared_ptr<const image::ColorConfig>> colorConfigOf(const nodes::Graph& graph,
                                                                const std::filesystem::path& folder);

}  // namespace pileus::cli
