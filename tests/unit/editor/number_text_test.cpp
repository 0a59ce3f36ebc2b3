// What may be typed into a number field: arithmetic, units, changes of the current value, and what is
// refused.
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <numbers>

#include "editor/toolkit/number_text.h"

namespace pileus::editor {
namespace {

double value(std::string_view text, double current = 0, std::string_view unit = "") {
  const Result<double> r = numberFromText(text, {current, unit});
  if (!r) ADD_FAILURE() << '"' << text << "\" was refused: " << r.error().message;
  return r ? *r : std::nan("");
}

std::string refusal(std::string_view text, std::string_view unit = "") {
  const Result<double> r = numberFromText(text, {1, unit});
  if (r) ADD_FAILURE() << '"' << text << "\" was taken as " << *r;
  return r ? "" : r.error().message;
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(NumberText, PlainNumbers) {
  EXPECT_EQ(value("5"), 5);
  EXPECT_EQ(value("  -0.25 "), -0.25);
  EXPECT_EQ(value(".5"), 0.5);
  EXPECT_EQ(value("1e3"), 1000);
  EXPECT_EQ(value("2.5E-2"), 0.025);
  EXPECT_EQ(value("-0"), 0);
  EXPECT_FALSE(std::signbit(value("-0")));
}

TEST(NumberText, ArithmeticHasTheUsualOrder) {
  EXPECT_EQ(value("3*2"), 6);
  EXPECT_EQ(value("1+2*3"), 7);
  EXPECT_EQ(value("(1+2)*3"), 9);
  EXPECT_EQ(value("10-4-3"), 3);
  EXPECT_EQ(value("24/4/2"), 3);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("2**3"), 8);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("--2"), 2);
}

TEST(NumberText, ConstantsAndFunctions) {
  EXPECT_DOUBLE_EQ(value("pi"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(value("2pi"), 2 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(value("tau/2"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(value("e"), std::numbers::e);
  EXPECT_DOUBLE_EQ(value("sqrt(2)"), std::numbers::sqrt2);
  EXPECT_NEAR(value("sin(30deg)"), 0.5, 1e-15);
  EXPECT_NEAR(value("sin(pi/6)"), 0.5, 1e-15);
  EXPECT_NEAR(value("cos(0.5 turn)"), -1, 1e-15);
  EXPECT_NEAR(value("asin(0.5)", 0, "deg"), 30, 1e-12);
  EXPECT_EQ(value("min(3, 1 + 1)"), 2);
  EXPECT_EQ(value("max(1,2,3)"), 3);
  EXPECT_EQ(value("clamp(7, 0, 5)"), 5);
  EXPECT_EQ(value("pow(2, 10)"), 1024);
  EXPECT_NEAR(value("max(1ft, 20cm)", 0, "m"), 0.3048, 1e-15);
}

TEST(NumberText, SignsThatArePasted) {
  EXPECT_EQ(value("\xe2\x88\x92"
                  "3"),
            -3);
  EXPECT_EQ(value("3\xc3\x97"
                  "2"),
            6);
  EXPECT_NEAR(value("sin(90\xc2\xb0)"), 1, 1e-15);
  EXPECT_NEAR(value("\xcf\x80"), std::numbers::pi, 1e-15);
}

TEST(NumberText, ChangesOfTheCurrentValue) {
  EXPECT_EQ(value("+1", 5), 6);
  EXPECT_EQ(value("+=1", 5), 6);
  EXPECT_EQ(value("-=1", 5), 4);
  EXPECT_EQ(value("-1", 5), -1) << "a minus alone is a sign";
  EXPECT_EQ(value("*2", 5), 10);
  EXPECT_EQ(value("*=2", 5), 10);
  EXPECT_EQ(value("/4", 5), 1.25);
  EXPECT_EQ(value("* (1 + 1)", 5), 10);
  EXPECT_NEAR(value("+10%", 50), 55, 1e-12);
  EXPECT_NEAR(value("-=10%", 50, "m"), 45, 1e-12);
  EXPECT_NEAR(value("+10cm", 1, "m"), 1.1, 1e-12);
}

TEST(NumberText, Lengths) {
  EXPECT_NEAR(value("1m 3mm", 0, "m"), 1.003, 1e-15);
  EXPECT_NEAR(value("1m3mm", 0, "m"), 1.003, 1e-15);
  EXPECT_NEAR(value("5ft 3in", 0, "m"), 1.6002, 1e-12);
  EXPECT_NEAR(value("2 km", 0, "m"), 2000, 1e-12);
  EXPECT_NEAR(value("2*50cm", 0, "m"), 1, 1e-15);
  EXPECT_NEAR(value("1m + 0.5", 0, "m"), 1.5, 1e-15) << "a plain number is in the parameter's own unit";
  EXPECT_NEAR(value("1m", 0, "cm"), 100, 1e-12);
  EXPECT_NEAR(value("1m/20cm"), 5, 1e-12);
  EXPECT_NEAR(value("1/50m", 0, "1/m"), 0.02, 1e-15) << "a mean free path as extinction";
  EXPECT_NEAR(value("0.5 1/m", 0, "1/m"), 0.5, 1e-15);
}

TEST(NumberText, AnglesTemperaturesAndLabels) {
  EXPECT_NEAR(value("pi rad", 0, "deg"), 180, 1e-12);
  EXPECT_NEAR(value("0.25turn", 0, "deg"), 90, 1e-12);
  EXPECT_NEAR(value("90deg", 0, "rad"), std::numbers::pi / 2, 1e-15);
  EXPECT_EQ(value("5500K", 0, "K"), 5500);
  EXPECT_EQ(value("24 fps", 0, "fps"), 24);
  EXPECT_EQ(value("512texels", 0, "texels"), 512);
  EXPECT_EQ(value("2*10 W/m^2", 0, "W/m^2"), 20);
  EXPECT_EQ(value("50%"), 0.5);
  EXPECT_EQ(value("50%", 0, "%"), 50);
}

TEST(NumberText, StopsMultiplyIntensitiesAndAddToStops) {
  EXPECT_EQ(value("+1 stop", 10, "W/m^2"), 20);
  EXPECT_EQ(value("-1 stops", 10, "W/m^2"), 5);
  EXPECT_NEAR(value("-0.5 EV", 10), 10 / std::numbers::sqrt2, 1e-12);
  EXPECT_EQ(value("+1 stop", 3, "stops"), 4);
  EXPECT_EQ(value("-0.5 stops", 3, "stops"), 2.5);
  EXPECT_EQ(value("2 stops", 3, "stops"), 2);
}

TEST(NumberText, KelvinsOfAColour) {
  EXPECT_EQ(kelvinFromText("5500K"), 5500);
  EXPECT_EQ(kelvinFromText(" 2*2000 K "), 4000);
  EXPECT_EQ(kelvinFromText("5500"), std::nullopt);
  EXPECT_EQ(kelvinFromText("red"), std::nullopt);
}

TEST(NumberText, RefusalsSayWhatIsWrong) {
  EXPECT_TRUE(contains(refusal(""), "needed"));
  EXPECT_TRUE(contains(refusal("   "), "needed"));
  EXPECT_TRUE(contains(refusal("3*"), "missing"));
  EXPECT_TRUE(contains(refusal("abc"), "abc"));
  EXPECT_TRUE(contains(refusal("2,5"), "comma"));
  EXPECT_TRUE(contains(refusal("(1+2"), ")"));
  EXPECT_TRUE(contains(refusal("1+2)"), ")"));
  EXPECT_TRUE(contains(refusal("1/0"), "zero"));
  EXPECT_TRUE(contains(refusal("/0"), "zero"));
  EXPECT_TRUE(contains(refusal("foo(2)"), "foo"));
  EXPECT_TRUE(contains(refusal("sqrt(-1)"), "not a number"));
  EXPECT_TRUE(contains(refusal("sqrt()"), "not expected"));
  EXPECT_TRUE(contains(refusal("sqrt(1,2)"), "one value"));
  EXPECT_TRUE(contains(refusal("pow(2)"), "2 values"));
  EXPECT_TRUE(contains(refusal("5deg", "m"), "A length is needed, not an angle"));
  EXPECT_TRUE(contains(refusal("5m"), "does not fit"));
  EXPECT_TRUE(contains(refusal("1m + 1deg", "m"), "cannot be added"));
  EXPECT_TRUE(contains(refusal("1m 3", "m"), "same kind"));
  EXPECT_TRUE(contains(refusal("1m*1m", "m"), "no meaning"));
  EXPECT_TRUE(contains(refusal("5 bananas", "m"), "bananas"));
  EXPECT_TRUE(contains(refusal("1 2"), "not expected"));
  EXPECT_TRUE(contains(refusal("$(rm)"), "not expected"));
  for (const char* bad :
       {"+",   "-",   "*",    "/",   "^",  ".",  "..",  "1..2",  "1e",       "e3",   "()", "%",
        "nan", "inf", "0x10", "1;2", "=1", "+=", "sin", "sin 3", "\xff\xfe", "1\n2", "-%", "5 %%"})
    refusal(bad);
}

TEST(NumberText, OverflowIsRefused) {
  EXPECT_TRUE(contains(refusal("1e999"), "too large"));
  EXPECT_TRUE(contains(refusal("10^400"), "finite"));
  EXPECT_TRUE(contains(refusal("exp(1e6)"), "finite"));
  EXPECT_TRUE(contains(refusal("1e300*1e300"), "finite"));
}

TEST(NumberText, DepthAndLengthHaveLimits) {
  EXPECT_EQ(value(std::string(20, '(') + "1" + std::string(20, ')')), 1);
  EXPECT_TRUE(contains(refusal(std::string(150, '(') + "1" + std::string(150, ')')), "deep"));
  EXPECT_TRUE(contains(refusal(std::string(300, '-') + "1"), "deep"));
  std::string powers = "1";
  for (int i = 0; i < 150; ++i) powers += "^1";
  EXPECT_TRUE(contains(refusal(powers), "deep"));
  EXPECT_TRUE(contains(refusal(std::string(100000, '1')), "long"));
}

TEST(NumberText, TheLocaleDoesNotMatter) {
  const char* was = std::setlocale(LC_ALL, nullptr);
  const std::string before = was ? was : "C";
  for (const char* name : {"de_DE.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, name);
    EXPECT_EQ(value("0.5"), 0.5);
    refusal("0,5");
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(NumberText, EveryShortTextIsAnsweredWithoutHarm) {
  const std::string letters = "0.5e+-*/^()%m ,Ksin";
  std::string text;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < 60000; ++i) {
    text.clear();
    for (std::size_t n = i * 2654435761u % 1000003; n > 0 && text.size() < 8; n /= letters.size())
      text += letters[n % letters.size()];
    if (const Result<double> r = numberFromText(text, {2, "m"})) {
      EXPECT_TRUE(std::isfinite(*r)) << text;
      ++taken;
    } else {
      EXPECT_FALSE(r.error().message.empty());
    }
  }
  EXPECT_GT(taken, 100u);
}

std::string stepped(std::string_view text, int caret, int by, int wantCaret = -1) {
  const auto r = steppedDigit(text, caret, by);
  if (!r) return "none";
  if (wantCaret >= 0) {
    EXPECT_EQ(r->caret, wantCaret) << text;
  }
  return r->text;
}

TEST(NumberText, ArrowsChangeTheDigitAtTheCaret) {
  EXPECT_EQ(stepped("5", 1, 1, 1), "6");
  EXPECT_EQ(stepped("9", 1, 1, 2), "10");
  EXPECT_EQ(stepped("129", 3, 1, 3), "130");
  EXPECT_EQ(stepped("129", 2, 1, 2), "139");
  EXPECT_EQ(stepped("129", 0, 1, 1), "229");
  EXPECT_EQ(stepped("0.05", 4, -1, 4), "0.04");
  EXPECT_EQ(stepped("0.05", 3, -1, 4), "-0.05");
  EXPECT_EQ(stepped("1.95", 4, 1, 4), "1.96");
  EXPECT_EQ(stepped("1.95", 3, 1, 3), "2.05");
  EXPECT_EQ(stepped("1.95", 1, 1, 1), "2.95");
  EXPECT_EQ(stepped("1.95", 2, 1, 1), "2.95") << "behind the point: the digit before it";
  EXPECT_EQ(stepped("-2", 2, 1), "-1");
  EXPECT_EQ(stepped("-1", 2, 2), "1");
  EXPECT_EQ(stepped("3*2", 3, 1), "3*3");
  EXPECT_EQ(stepped("3-2", 3, 1), "3-3");
  EXPECT_EQ(stepped("12 m", 2, 1), "13 m");
  EXPECT_EQ(stepped("", 0, 1), "none");
  EXPECT_EQ(stepped("abc", 2, 1), "none");
  EXPECT_EQ(stepped("1.2.3", 5, 1), "none");
  EXPECT_EQ(stepped("12345678901234567890", 20, 1), "none");
}

}  // namespace
}  // namespace pileus::editor
