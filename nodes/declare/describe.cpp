#include "nodes/declare/describe.h"

namespace pileus::nodes {

std::string labelFromId(std::string_view id) {
  std::string label(id);
  for (char& c : label)
    if (c == '_') c = ' ';
  // Ids are American, as code is; labels are British, as text is.
  for (const auto& [code, text] : {std::pair("color", "colour"), std::pair("center", "centre")})
    if (const std::size_t at = label.find(code); at != std::string::npos)
      label.replace(at, std::string_view(code).size(), text);
  if (!label.empty() && label[0] >= 'a' && label[0] <= 'z')
    label[0] = static_cast<char>(label[0] - 'a' + 'A');
  return label;
}

namespace detail {

SocketSpec& addSocket(std::vector<SocketSpec>& sockets, std::string id, SocketType type) {
  SocketSpec& s = sockets.emplace_back();
  s.label = labelFromId(id);
  s.id = std::move(id);
  s.type = type;
  return s;
}

ParamSpec& addParam(std::vector<ParamSpec>& params, std::string id, ParamType type) {
  ParamSpec& p = params.emplace_back();
  p.label = labelFromId(id);
  p.id = std::move(id);
  p.type = type;
  p.hardMin = -1e9, p.hardMax = 1e9;
  return p;
}

Members::Members(const NodeType& type) {
  for (const SocketSpec& s : type.inputs) assign.push_back(s.assign);
  for (const ParamSpec& p : type.params) set.push_back(p.set);
  for (const SocketSpec& s : type.outputs) read.push_back(s.read);
}

void Members::fill(void* in, std::span<const std::vector<SocketValue>> inputs,
                   std::span<const ParamValue> params) const {
  for (std::size_t i = 0; i < assign.size(); ++i)
    for (const SocketValue& v : inputs[i]) assign[i](in, v);
  for (std::size_t i = 0; i < set.size(); ++i) set[i](in, params[i]);
}

std::vector<SocketValue> Members::given(const void* out) const {
  std::vector<SocketValue> values;
  for (const auto& r : read) values.push_back(r(out));
  return values;
}

}  // namespace detail

}  // namespace pileus::nodes
