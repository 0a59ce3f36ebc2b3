#pragma once
// A question with two or three answers, asked in a dialog. The last answer is also that of Esc.
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace pileus::editor {

struct Question {
  struct Answer {
    std::string label;
    std::function<void()> run;  ///< may be empty: just closes
  };
  std::string id;           ///< for the trace: "dialog/<id>/0"
  std::string title, text;  ///< text wraps
  std::vector<Answer> answers;
};

/// Questions that wait, in order; the first one is on the screen.
struct Questions {
  std::deque<Question> waiting;
  void ask(Question question) { waiting.push_back(std::move(question)); }
  bool open() const { return !waiting.empty(); }
};

struct Ui;
void drawQuestions(Ui& ui, Questions& questions);

}  // namespace pileus::editor
