// The node reference, from the declarations: nothing in it is written twice.
#include "nodes/docs_export.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "nodes/node_type.h"

namespace pileus::nodes {
namespace {

using Json = nlohmann::ordered_json;

std::string_view typeName(ParamType type) {
  switch (type) {
    case ParamType::Bool:
      return "true/false";
    case ParamType::Int:
      return "whole number";
    case ParamType::Float:
      return "number";
    case ParamType::Vector:
      return "3 numbers";
    case ParamType::Color:
      return "colour";
    case ParamType::Text:
      return "text";
    case ParamType::File:
      return "file";
    case ParamType::Enum:
      return "choice";
    case ParamType::Curve:
      return "curve";
    case ParamType::Ramp:
      return "colour ramp";
  }
  return "";
}

bool hasRange(const ParamSpec& spec) {
  return spec.type == ParamType::Int || spec.type == ParamType::Float || spec.type == ParamType::Vector ||
         spec.type == ParamType::Color;
}

std::string rangeText(const ParamSpec& spec) {
  if (!hasRange(spec)) return "";
  return formatNumber(spec.hardMin) + " .. " + formatNumber(spec.hardMax);
}

std::string defaultText(const ParamSpec& spec) {
  const std::string text = formatParam(spec, spec.fallback);
  return text.empty() ? "(empty)" : text;
}

/// A table cell: no line breaks, no column marks.
std::string cell(std::string text) {
  std::string out;
  for (const char c : text) {
    if (c == '|')
      out += "\\|";
    else
      out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string socketKind(const SocketSpec& socket) {
  std::string text(socket.any ? "any" : enumId(socket.type));
  if (socket.many) text += ", many";
  if (socket.required) text += ", required";
  return text;
}

void socketTable(std::string& out, std::string_view title, const std::vector<SocketSpec>& sockets) {
  if (sockets.empty()) return;
  out += fmt::format("| {} | type | |\n|---|---|---|\n", title);
  for (const SocketSpec& s : sockets)
    out += fmt::format("| `{}` | {} | {} |\n", s.id, socketKind(s), cell(s.help));
  out += '\n';
}

void paramTable(std::string& out, const std::vector<ParamSpec>& params) {
  if (params.empty()) return;
  out += "| parameter | type | default | range | unit | |\n|---|---|---|---|---|---|\n";
  for (const ParamSpec& p : params) {
    std::string help = p.help;
    for (const Choice& choice : p.choices) help += fmt::format(" **{}**: {}", choice.id, choice.help);
    out += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", p.id, typeName(p.type), cell(defaultText(p)),
                       rangeText(p), p.unit, cell(help));
  }
  out += '\n';
}

std::vector<std::string> categories() {
  std::vector<std::string> list;
  for (const NodeType& type : allNodeTypes())
    if (std::find(list.begin(), list.end(), type.category) == list.end()) list.push_back(type.category);
  return list;
}

Json valueJson(const ParamValue& value) {
  return std::visit(
      [](const auto& v) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, dvec3>) {
          return Json::array({v.x, v.y, v.z});
        } else if constexpr (std::is_same_v<std::decay_t<decltype(v)>, Curve>) {
          Json list = Json::array({std::string(enumId(v.shape))});
          for (const dvec2& p : v.points) list.push_back(Json::array({p.x, p.y}));
          return list;
        } else if constexpr (std::is_same_v<std::decay_t<decltype(v)>, Ramp>) {
          Json list = Json::array({std::string(enumId(v.shape))});
          for (const RampStop& s : v.stops)
            list.push_back(Json::array({s.at, s.color.x, s.color.y, s.color.z}));
          return list;
        } else {
          return v;
        }
      },
      value);
}

Json socketsJson(const std::vector<SocketSpec>& sockets, bool inputs) {
  Json list = Json::array();
  for (const SocketSpec& s : sockets) {
    Json json = {{"id", s.id}, {"label", s.label}, {"type", s.any ? "any" : std::string(enumId(s.type))}, {"help", s.help}};
    if (inputs) json["many"] = s.many, json["required"] = s.required;
    list.push_back(std::move(json));
  }
  return list;
}

std::string_view typeId(ParamType type) {
  constexpr std::string_view ids[] = {"bool", "int", "float", "vector", "color", "text", "file",
                                      "enum", "curve", "ramp"};
  return ids[static_cast<std::size_t>(type)];
}

Json paramJson(const ParamSpec& p) {
  Json json = {{"id", p.id},
               {"label", p.label},
               {"type", std::string(typeId(p.type))},
               {"default", valueJson(p.fallback)},
               {"unit", p.unit},
               {"help", p.help}};
  if (hasRange(p)) {
    json["range"] = {p.hardMin, p.hardMax};
    if (p.softMin < p.softMax) json["softRange"] = {p.softMin, p.softMax};
  }
  if (!p.choices.empty()) {
    json["choices"] = Json::array();
    for (const Choice& c : p.choices)
      json["choices"].push_back({{"id", c.id}, {"label", c.label}, {"help", c.help}});
  }
  if (p.type == ParamType::File) json["kinds"] = p.fileKinds, json["writes"] = p.writes;
  return json;
}

}  // namespace

std::string nodesMarkdown() {
  std::string out =
      "# Nodes\n\nEvery node type with its sockets and parameters. Generated by `pileus nodes --markdown`; "
      "do not edit.\n";
  for (const std::string& category : categories()) {
    out += "\n## " + category + "\n";
    for (const NodeType& type : allNodeTypes()) {
      if (type.category != category) continue;
      out += fmt::format("\n### {} - `{}`\n\n{}\n\n", type.label, type.id, type.help);
      socketTable(out, "input", type.inputs);
      paramTable(out, type.params);
      socketTable(out, "output", type.outputs);
      while (out.ends_with("\n\n")) out.pop_back();
    }
  }
  return out;
}

std::string nodesJson() {
  Json list = Json::array();
  for (const NodeType& type : allNodeTypes()) {
    Json params = Json::array();
    for (const ParamSpec& p : type.params) params.push_back(paramJson(p));
    list.push_back({{"id", type.id},
                    {"version", type.version},
                    {"label", type.label},
                    {"category", type.category},
                    {"help", type.help},
                    {"keywords", type.keywords},
                    {"output", type.isOutput},
                    {"inputs", socketsJson(type.inputs, true)},
                    {"params", std::move(params)},
                    {"outputs", socketsJson(type.outputs, false)}});
  }
  return Json{{"nodes", std::move(list)}}.dump(2) + "\n";
}

std::string nodesText() {
  std::string out;
  for (const std::string& category : categories()) {
    out += (out.empty() ? "" : "\n") + category + "\n";
    for (const NodeType& type : allNodeTypes()) {
      if (type.category != category) continue;
      out += fmt::format("  {:<22} {}\n", type.id, type.label);
      for (const SocketSpec& s : type.inputs) out += fmt::format("    <- {:<19} {}\n", s.id, socketKind(s));
      for (const ParamSpec& p : type.params) {
        std::string choices;
        for (const Choice& c : p.choices) choices += (choices.empty() ? "" : ", ") + c.id;
        const std::string allowed = choices.empty() ? rangeText(p) : choices;
        out +=
            fmt::format("       {:<19} {}{}{}{}\n", p.id, defaultText(p), p.unit.empty() ? "" : " " + p.unit,
                        allowed.empty() ? "" : "  ", allowed.empty() ? "" : "(" + allowed + ")");
      }
      for (const SocketSpec& s : type.outputs) out += fmt::format("    -> {:<19} {}\n", s.id, enumId(s.type));
    }
  }
  return out;
}

}  // namespace pileus::nodes
