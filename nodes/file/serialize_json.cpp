#include "nodes/file/serialize_json.h"

#include <set>

namespace pileus::nodes {
namespace {

constexpr int kDeepest = 64;

std::string position(std::string_view text, std::size_t byte) {
  int line = 1, column = 1;
  for (std::size_t i = 0; i + 1 < byte && i < text.size(); ++i) {
    if (text[i] == '\n')
      ++line, column = 1;
    else if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80)
      ++column;  // characters, not bytes
  }
  return fmt::format("line {}, column {}", line, column);
}

/// The library's reason without its own prefix and position; its length may come from the file.
std::string reason(std::string what) {
  if (const auto at = what.find("column "); at != std::string::npos) {
    if (const auto colon = what.find(": ", at); colon != std::string::npos) what.erase(0, colon + 2);
  } else if (const auto bracket = what.find("] "); bracket != std::string::npos) {
    what.erase(0, bracket + 2);
  }
  if (what.size() > 300) what = what.substr(0, 300) + "...";
  for (char& c : what)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return what;
}

/// Where something too deep begins, as a byte offset + 1; 0 = nowhere.
std::size_t tooDeep(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kDeepest) return i + 1;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return 0;
}

/// "Sun.elevation" for what belongs to a node, "settings.size" otherwise.
std::string place(const std::vector<std::string>& path) {
  std::size_t first = 0;
  std::string text;
  if (path.size() > 1 && path[0] == "nodes") first = 1;
  for (std::size_t i = first; i < path.size(); ++i) {
    if (first == 1 && i == 2 && path[i] == "params" && path.size() > 3) continue;
    text += (text.empty() ? "" : ".") + path[i];
  }
  return text;
}

/// Sees every name while the text is parsed and reports those given twice in one object.
class DuplicateFinder {
 public:
  explicit DuplicateFinder(std::vector<Fault>& faults) : faults_(&faults) {}
  bool operator()(int, Json::parse_event_t event, Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::object_start) {
      open_.emplace_back();
      path_.emplace_back();
    } else if (event == Event::object_end) {
      open_.pop_back();
      path_.pop_back();
    } else if (event == Event::key) {
      path_.back() = parsed.get_ref<const std::string&>();
      if (!open_.back().insert(path_.back()).second)
        faults_->push_back({true, place(path_), "is given twice", true});
    }
    return true;
  }

 private:
  std::vector<Fault>* faults_;
  std::vector<std::set<std::string>> open_;
  std::vector<std::string> path_;
};

void writeText(std::string& out, const std::string& text) {
  // The library's escaping; bytes that are no UTF-8 (a path may hold them) become U+FFFD, so that the file
  // stays readable.
  out += Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool onOneLine(const Json& array) {
  bool numbers = array.empty();
  for (const Json& item : array) {
    if (item.is_array() ? !onOneLine(item) : item.is_structured()) return false;
    numbers = numbers || item.is_number() || item.is_array();
  }
  return numbers;
}

void write(std::string& out, const Json& json, int indent) {
  const auto line = [&](int depth) { out.append(1, '\n').append(static_cast<std::size_t>(2 * depth), ' '); };
  if (json.is_object()) {
    if (json.empty()) {
      out += "{}";
      return;
    }
    char separator = '{';
    for (const auto& [key, value] : json.items()) {
      out += separator;
      separator = ',';
      line(indent + 1);
      writeText(out, key);
      out += ": ";
      write(out, value, indent + 1);
    }
    line(indent);
    out += '}';
  } else if (json.is_array()) {
    const bool one = onOneLine(json);
    out += '[';
    for (std::size_t i = 0; i < json.size(); ++i) {
      if (i > 0) out += one ? ", " : ",";
      if (!one) line(indent + 1);
      write(out, json[i], indent + 1);
    }
    if (!one) line(indent);
    out += ']';
  } else if (json.is_string()) {
    writeText(out, json.get_ref<const std::string&>());
  } else if (json.is_number_float()) {
    out += formatNumber(json.get<double>());
  } else {
    out += json.dump();
  }
}

}  // namespace

Result<Json> parseJson(std::string_view text, std::vector<Fault>& faults) {
  if (const std::size_t byte = tooDeep(text))
    return fail(Code::Input, "{}: nested deeper than {}", position(text, byte), kDeepest);
  try {
    return Json::parse(text.begin(), text.end(), DuplicateFinder(faults));
  } catch (const Json::parse_error& e) {
    return fail(Code::Input, "{}: not JSON: {}", position(text, e.byte), reason(e.what()));
  } catch (const Json::exception& e) {  // a number beyond double: no position comes with it
    return fail(Code::Input, "not JSON: {}", reason(e.what()));
  }
}

std::string writeJson(const Json& json) {
  std::string out;
  write(out, json, 0);
  return out + '\n';
}

}  // namespace pileus::nodes
