#include "editor/toolkit/number_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "editor/toolkit/number_units.h"

namespace pileus::editor {
namespace {

constexpr std::size_t kLongest = 400;  // characters
constexpr int kDeepest = 60;           // brackets, signs and powers within one another

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Signs that people paste, as plain ones.
std::string plainSigns(std::string_view text) {
  static constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
      {"\xe2\x88\x92", "-"}, {"\xc3\x97", "*"}, {"\xc2\xb7", "*"}, {"\xc3\xb7", "/"}, {"\xc2\xb0", "deg"},
      {"\xcf\x80", "pi"},    {"\xc2\xa0", " "}, {"\xc2\xb5", "u"}, {"\xce\xbc", "u"}};
  std::string out;
  while (!text.empty()) {
    const auto sign = std::find_if(std::begin(kSigns), std::end(kSigns),
                                   [&](const auto& s) { return text.starts_with(s.first); });
    const bool known = sign != std::end(kSigns);
    out += known ? sign->second : text.substr(0, 1);
    text.remove_prefix(known ? sign->first.size() : 1);
  }
  return out;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Recursive descent; the first error stays.
class Parser {
 public:
  Parser(std::string_view text, const OwnUnit& own) : rest_(text), own_(own) {}

  Result<Quantity> all() {
    Quantity q = sum();
    skip();
    if (error_.empty() && !rest_.empty()) {
      if (rest_[0] == ',')
        note("Decimals are written with a point, not a comma.");
      else if (rest_[0] == ')')
        note("There is a ) too many.");
      else
        note(fmt::format("\"{}\" is not expected here.", shown(rest_)));
    }
    if (!error_.empty()) return fail(Code::Arguments, "{}", error_);
    if (!std::isfinite(q.value)) return fail(Code::Arguments, "The result is not a finite number.");
    return q;
  }

 private:
  void note(std::string error) {
    if (error_.empty()) error_ = std::move(error);
    rest_ = {};
  }
  static std::string shown(std::string_view text) {
    return std::string(text.substr(0, 16)) + (text.size() > 16 ? "\xe2\x80\xa6" : "");
  }
  void skip() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t')) rest_.remove_prefix(1);
  }
  bool take(char c) {
    skip();
    if (rest_.empty() || rest_[0] != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// Letters; digits within where it is a function's name ("atan2"). "1m3mm" has two units.
  std::string_view word(bool digits) {
    std::size_t n = 0;
    while (n < rest_.size() && (isLetter(rest_[n]) || (digits && n > 0 && isDigit(rest_[n])))) ++n;
    const std::string_view taken = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return taken;
  }

  /// The two of a sum in one kind: a plain number counts in the parameter's own unit.
  bool alike(Quantity& a, Quantity& b) {
    if (a.kind == b.kind) return true;
    Quantity& plain = a.kind == UnitKind::None ? a : b;
    const Quantity& other = &plain == &a ? b : a;
    if (plain.kind == UnitKind::Percent) plain.kind = UnitKind::None;
    if (plain.kind == UnitKind::None && other.kind == UnitKind::Percent) return true;
    if (plain.kind == UnitKind::None && own_.kind == other.kind) {
      plain = {plain.value * own_.factor, other.kind};
      return true;
    }
    note(fmt::format("{} and {} cannot be added.", kindName(a.kind), kindName(b.kind)));
    return false;
  }

  Quantity sum() {
    Quantity left = product();
    for (;;) {
      const bool plus = take('+'), minus = !plus && take('-');
      if (!plus && !minus) return left;
      Quantity right = product();
      if (!error_.empty() || !alike(left, right)) return {};
      const UnitKind kind = left.kind == UnitKind::Percent ? right.kind : left.kind;
      left = {left.value + (plus ? right.value : -right.value), kind};
    }
  }

  static bool plain(const Quantity& q) { return q.kind == UnitKind::None || q.kind == UnitKind::Percent; }

  Quantity product() {
    Quantity left = signedPower();
    for (;;) {
      skip();
      const bool times = !rest_.starts_with("**") && take('*'), over = !times && take('/');
      if (!times && !over) return left;
      const Quantity right = signedPower();
      if (!error_.empty()) return {};
      if (over && right.value == 0) return note("Something is divided by zero."), Quantity{};
      const double value = times ? left.value * right.value : left.value / right.value;
      if (times && !plain(left) && !plain(right))
        return note(fmt::format("{} times {} has no meaning here.", kindName(left.kind),
                                kindName(right.kind))),
               Quantity{};
      if (times)
        left = {value, plain(left) ? (plain(right) ? UnitKind::None : right.kind) : left.kind};
      else if (plain(right))
        left = {value, plain(left) ? UnitKind::None : left.kind};
      else if (left.kind == right.kind)
        left = {value, UnitKind::None};
      else if (plain(left) && right.kind == UnitKind::Length)
        left = {value, UnitKind::PerLength};
      else
        return note(fmt::format("{} by {} has no meaning here.", kindName(left.kind), kindName(right.kind))),
               Quantity{};
    }
  }

  Quantity signedPower() {
    if (++depth_ > kDeepest) return note("This is nested too deeply."), Quantity{};
    Quantity q;
    if (take('-'))
      q = signedPower(), q.value = -q.value;
    else if (take('+'))
      q = signedPower();
    else
      q = power();
    --depth_;
    return q;
  }

  Quantity power() {
    const Quantity base = quantity();
    skip();
    if (!error_.empty() || (!rest_.starts_with('^') && !rest_.starts_with("**"))) return base;
    rest_.remove_prefix(rest_[0] == '^' ? 1 : 2);
    const Quantity exponent = signedPower();
    if (!error_.empty()) return {};
    if (!plain(base) || !plain(exponent)) return note("Only plain numbers have powers."), Quantity{};
    return {std::pow(base.value, exponent.value), UnitKind::None};
  }

  /// A number, constant, function or bracket, with a unit; "1m 3mm" is one quantity.
  Quantity quantity() {
    skip();
    if (rest_.empty()) return note("A number is missing at the end."), Quantity{};
    const bool digits = isDigit(rest_[0]) || rest_[0] == '.';
    Quantity q = unit(digits ? number() : named());
    while (digits && error_.empty() && q.kind != UnitKind::None && q.kind != UnitKind::Percent) {
      skip();
      if (rest_.empty() || !(isDigit(rest_[0]) || rest_[0] == '.')) break;
      const Quantity more = unit(number());
      if (!error_.empty()) break;
      if (more.kind != q.kind)
        return note("After a number with a unit, the next one needs a unit of the same kind."), Quantity{};
      q.value += more.value;
    }
    return q;
  }

  Quantity number() {
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error == std::errc::result_out_of_range)
      return note("The number is too large or too small."), Quantity{};
    if (error != std::errc()) return note(fmt::format("\"{}\" is not a number.", shown(rest_))), Quantity{};
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return {value, UnitKind::None};
  }

  Quantity unit(Quantity q) {
    skip();
    if (!error_.empty() || rest_.empty()) return q;
    if (take('%')) {
      if (q.kind != UnitKind::None) return note("Per cent is for plain numbers."), Quantity{};
      return {q.value / 100, UnitKind::Percent};
    }
    if (!isLetter(rest_[0])) return q;
    const std::string_view name = word(false);
    if (name == "pi" && q.kind == UnitKind::None) return unit({q.value * std::numbers::pi, q.kind});
    const Unit* u = findUnit(name);
    if (!u) return note(fmt::format("\"{}\" is no unit that is known here.", shown(name))), Quantity{};
    if (q.kind != UnitKind::None) return note("A quantity has one unit only."), Quantity{};
    return {q.value * u->factor, u->kind};
  }

  Quantity named() {
    if (take('(')) return bracket();
    if (rest_[0] == ',') return note("Decimals are written with a point, not a comma."), Quantity{};
    if (!isLetter(rest_[0]))
      return note(fmt::format("\"{}\" is not expected here.", shown(rest_))), Quantity{};
    const std::string_view name = word(true);
    if (name == "pi") return {std::numbers::pi, UnitKind::None};
    if (name == "tau") return {2 * std::numbers::pi, UnitKind::None};
    if (name == "e") return {std::numbers::e, UnitKind::None};
    if (!take('(')) return note(fmt::format("\"{}\" is not known.", shown(name))), Quantity{};
    Quantity arguments[3];
    int count = 0;
    do {
      if (count == 3) return note(fmt::format("{}() takes fewer values.", name)), Quantity{};
      arguments[count++] = bracketed();
    } while (error_.empty() && take(','));
    if (error_.empty() && !take(')')) note("A ) is missing.");
    if (!error_.empty()) return {};
    return call(name, arguments, count);
  }

  Quantity bracketed() {
    if (++depth_ > kDeepest) return note("This is nested too deeply."), Quantity{};
    const Quantity q = sum();
    --depth_;
    return q;
  }
  Quantity bracket() {
    const Quantity q = bracketed();
    if (error_.empty() && !take(')')) note("A ) is missing.");
    return q;
  }

  Quantity call(std::string_view name, Quantity* a, int count) {
    const auto f = callFunction(name, a, count);
    if (!f) return note(f.error().message), Quantity{};
    return *f;
  }

  std::string_view rest_;
  const OwnUnit& own_;
  std::string error_;
  int depth_ = 0;
};

/// The text less a unit of the parameter's own that only a label knows ("24 fps", "10 W/m^2").
std::string_view withoutLabel(std::string_view text, const OwnUnit& own, std::string_view label) {
  const bool unknown = own.kind == UnitKind::None || own.kind == UnitKind::PerLength;
  if (!unknown || label.empty() || !text.ends_with(label)) return text;
  const std::string_view left = text.substr(0, text.size() - label.size());
  const bool apart = left.ends_with(' ') || (isLetter(label[0]) && !left.empty() && isDigit(left.back()));
  return apart ? trimmed(left) : text;
}

enum class Change { None, Add, Subtract, Multiply, Divide };

Change takeChange(std::string_view& text) {
  if (text.empty()) return Change::None;
  const bool assigns = text.size() > 1 && text[1] == '=';
  const char c = text[0];
  if (c != '+' && c != '*' && c != '/' && !(c == '-' && assigns)) return Change::None;
  text = trimmed(text.substr(assigns ? 2 : 1));
  return c == '+' ? Change::Add : c == '-' ? Change::Subtract : c == '*' ? Change::Multiply : Change::Divide;
}

Result<double> changed(double current, Change change, const Quantity& q, const OwnUnit& own) {
  const bool plain = q.kind == UnitKind::None;
  if (change == Change::Multiply || change == Change::Divide) {
    if (!plain && q.kind != UnitKind::Percent) return fail(Code::Arguments, "A factor has no unit.");
    if (change == Change::Divide && q.value == 0)
      return fail(Code::Arguments, "Something is divided by zero.");
    return change == Change::Multiply ? current * q.value : current / q.value;
  }
  const double sign = change == Change::Add ? 1 : -1;
  if (q.kind == UnitKind::Percent && own.kind != UnitKind::Percent) return current * (1 + sign * q.value);
  if (q.kind == UnitKind::Stops && own.kind != UnitKind::Stops) return current * std::exp2(sign * q.value);
  PILEUS_TRY(const double by, inOwnUnit(q, own));
  return current + sign * by;
}

Result<double> meant(std::string_view text, const NumberContext& context) {
  const OwnUnit own = ownUnit(context.unit);
  std::string_view rest = trimmed(text);
  if (rest.empty()) return fail(Code::Arguments, "A number is needed.");
  const bool negative = rest[0] == '-';
  const Change change = takeChange(rest);
  rest = withoutLabel(rest, own, context.unit);
  PILEUS_TRY(const Quantity q, Parser(rest, own).all());
  if (change != Change::None) return changed(context.current, change, q, own);
  if (q.kind == UnitKind::Stops && own.kind != UnitKind::Stops) return context.current * std::exp2(q.value);
  if (q.kind == UnitKind::Stops && negative) return context.current + q.value;
  return inOwnUnit(q, own);
}

}  // namespace

Result<double> numberFromText(std::string_view text, const NumberContext& context) {
  if (text.size() > kLongest) return fail(Code::Arguments, "This is too long.");
  PILEUS_TRY(const double value, meant(plainSigns(text), context));
  if (!std::isfinite(value)) return fail(Code::Arguments, "The result is not a finite number.");
  return value == 0 ? 0.0 : value;
}

std::optional<double> kelvinFromText(std::string_view text) {
  if (text.size() > kLongest) return std::nullopt;
  const std::string plain = plainSigns(text);
  const OwnUnit none = ownUnit("");
  const Result<Quantity> q = Parser(trimmed(plain), none).all();
  if (!q || q->kind != UnitKind::Temperature) return std::nullopt;
  return q->value;
}

std::optional<TextAndCaret> steppedDigit(std::string_view text, int caret, int by) {
  const auto size = static_cast<int>(text.size());
  const auto at = [&](int i) { return text[static_cast<std::size_t>(i)]; };
  caret = std::clamp(caret, 0, size);
  int digit = caret - 1;
  if (digit >= 0 && at(digit) == '.') --digit;
  if (digit < 0 || !isDigit(at(digit))) digit = caret;  // at the front: the first digit
  if (digit >= size || !isDigit(at(digit))) return std::nullopt;
  int first = digit, last = digit + 1, point = -1;
  while (first > 0 && (isDigit(at(first - 1)) || at(first - 1) == '.')) --first;
  while (last < size && (isDigit(at(last)) || at(last) == '.')) ++last;
  std::string digits;
  int decimals = 0, place = 0;
  for (int i = first; i < last; ++i) {
    if (at(i) == '.') {
      if (point >= 0) return std::nullopt;
      point = i;
      continue;
    }
    digits += at(i);
    if (point >= 0) ++decimals;
    if (i > digit) ++place;
  }
  if (digits.size() > 15) return std::nullopt;
  // A sign belongs to the number unless it stands between two values.
  int before = first - 1;
  const bool signedHere = before >= 0 && at(before) == '-' &&
                          (before == 0 || !(isDigit(at(before - 1)) || at(before - 1) == ')'));
  long long value = std::stoll(digits);
  if (signedHere) value = -value, first = before;
  long long step = by;
  for (int i = 0; i < place; ++i) step *= 10;
  value += step;
  std::string shown = std::to_string(std::abs(value));
  const std::size_t wanted = std::max(digits.size(), static_cast<std::size_t>(decimals) + 1);
  if (shown.size() < static_cast<std::size_t>(decimals) + 1) shown.insert(0, wanted - shown.size(), '0');
  if (decimals > 0) shown.insert(shown.size() - static_cast<std::size_t>(decimals), ".");
  if (value < 0) shown.insert(0, "-");
  TextAndCaret out;
  out.text = std::string(text.substr(0, static_cast<std::size_t>(first))) + shown +
             std::string(text.substr(static_cast<std::size_t>(last)));
  // The same place of value, counted from the number's end.
  const int fromEnd = place + (place >= decimals && decimals > 0 ? 1 : 0);
  out.caret = std::max(first + (value < 0 ? 1 : 0), first + static_cast<int>(shown.size()) - fromEnd);
  return out;
}

}  // namespace pileus::editor
