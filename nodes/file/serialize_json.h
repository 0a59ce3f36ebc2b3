#pragma once
// JSON as graph files have it; private to serialize*.cpp and docs_export.cpp.
#include <nlohmann/json.hpp>

#include "nodes/file/serialize.h"

namespace pileus::nodes {

using Json = nlohmann::json;  // objects are sorted by key

/// Strict JSON nested at most 64 deep. Names given twice become error faults (the last one counts). The Error
/// holds line and column.
Result<Json> parseJson(std::string_view text, std::vector<Fault>& faults);

/// Two-space indent; a list of numbers (with texts among them) on one line; shortest round-trip numbers; ends
/// with a line break.
std::string writeJson(const Json& json);

/// A parameter's constant as a file has it.
Json paramJson(const ParamValue& value);

/// The member of a clipboard's text, "keys", that sets keys apart from nodes.
inline constexpr char kContent[] = "content";

/// Graph to and from JSON, without settings for the clipboard.
Json graphJson(const Graph& graph, bool withSettings);
/// Reads what it can; everything wrong becomes a fault. `json` is an object of the current format.
Graph graphFromJson(const Json& json, std::vector<Fault>& faults);

/// Faults of links, those within groups too: sockets, types, taken inputs and cycles. `prefix` is the path of
/// the group.
void checkLinks(const Graph& graph, std::vector<Fault>& faults, const std::string& prefix);

}  // namespace pileus::nodes
