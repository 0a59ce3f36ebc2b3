// llvmpipe ends all loops of an invocation, without a word, once they have run 65535 times in total, nested
// ones included; the 8 lanes of a vector share that count. With RESUME 1 a march counts its own iterations,
// pauses where its share of them is used up, and leaves what the next dispatch goes on from. Each lane may
// spend an eighth, so that 8 lanes that never wait in the same loop are within the limit too.
// Without RESUME these functions are empty: a march runs to its end. REACHED: lights of which the pass keeps
// something from step to step.
#pragma once
#include "shared/resume.h"
#ifndef RESUME
#define RESUME 0
#endif
#ifndef REACHED
#define REACHED 1
#endif

bool lit = false;        // is it known what reaches the place where the last step ended, ...
float reached[REACHED];  // ... and how much of each light does?

void forgetLights() {
  lit = false;
  for (int l = 0; l < REACHED; ++l) reached[l] = 0.0;
}

vec4 seenBeside[2] = vec4[2](vec4(0.0), vec4(0.0));  // what a pass keeps besides

#if RESUME
struct MarchState {
  vec4 seen;   // whatever the pass has gathered of the ray so far
  vec4 beside[2];
  vec2 place;  // where the stretch of the camera ray begins
  vec2 step;   // next one of that stretch: where it begins, its length
  int light;   // first one whose part in that step is missing
  int item;    // of the light's volumes to march through: the first one that is missing
  float tau;   // of those before it
  int phase;
  int lit;                 // 1: what the lights reach there is known, ...
  float reached[REACHED];  // ... of each
};
const int kInMedia = 0, kAtSolid = 1, kFinished = 2;
layout(std430, binding = BIND_MARCH_STATES) buffer MarchStates {
  int unfinished, unused_[3];
  MarchState states[];
};
uniform int dispatchIndex;  // 0: begin
uniform int budget;         // iterations a lane may begin its next piece of work with
// Iterations of a stretch's list, of looking at a step, and of a sample but for its shadow marches.
uniform int stretchCost, stepCost, sampleCost;

MarchState state;
int spent = 0;
bool paused = false;

void spend(int iterations) { spent += iterations; }
void spendStretch() { spend(stretchCost); }
void spendStep() { spend(stepCost); }
void spendSample() { spend(sampleCost); }
bool mustPause() { return spent >= budget; }

// What the march of a slot has seen so far; as it is where that begins. False: it is finished.
bool goOn(int slot, inout vec4 seen) {
  state.place = vec2(0.0), state.step = vec2(0.0);
  state.light = 0, state.item = 0, state.tau = 0.0, state.phase = kInMedia;
  forgetLights();
  if (dispatchIndex == 0) return true;
  state = states[slot];
  seen = state.seen;
  seenBeside = state.beside;
  lit = state.lit == 1;
  reached = state.reached;
  return state.phase != kFinished;
}
// Behind all work of a dispatch.
void keep(int slot, vec4 seen) {
  state.seen = seen;
  state.beside = seenBeside;
  state.lit = lit ? 1 : 0;
  state.reached = reached;
  if (!paused) state.phase = kFinished;
  states[slot] = state;
  if (paused) atomicAdd(unfinished, 1);
}

// Where to go on.
bool mediaAreDue() { return state.phase == kInMedia; }
vec2 firstPlace() { return state.place; }
// A stretch's first step, unless it was begun before: .y > 0.
void goOnAt(inout float at, inout float wanted) {
  at = state.step.y > 0.0 ? state.step.x : at;
  wanted = state.step.y > 0.0 ? state.step.y : wanted;
}
// Is light l still missing, and may it be begun now?
bool lightIsDue(int l) { return l >= state.light && !paused; }
int firstItem() { return state.item; }
float firstTau() { return state.tau; }

// Behind the search for the next step with something in it: this one, ...
void foundStep(vec2 step) { state.step = step; }
// ... or none, for the stretch is over or the budget is.
void foundNothing(vec2 next, bool more) {
  paused = more;
  state.step = next;
  state.light = paused ? 0 : 1 << 30;
}
// Behind a volume of a light's march: is it to wait here?
bool pausesAtItem() {
  paused = paused || mustPause();
  return paused;
}
void itemsDone(int next, float tau) {
  state.item = paused ? next : 0;
  state.tau = paused ? tau : 0.0;
}
void lightDone(int l) { state.light = paused ? l : l + 1; }
// All lights are due once more.
void lightsAgain() { state.light = 0; }
// `more`: there is something behind it to be done.
void stepDone(vec2 next, bool more) {
  state.step = next, state.light = 0;
  paused = mustPause() && more;
}
void stretchDone(vec2 next, bool more) {
  state.place = next, state.step = vec2(0.0);
  paused = mustPause() && more;
}
void mediaDone() { state.phase = paused ? kInMedia : kAtSolid; }
#else
const bool paused = false;

void spend(int iterations) {}
void spendStretch() {}
void spendStep() {}
void spendSample() {}
bool mustPause() { return false; }
bool goOn(int slot, inout vec4 seen) {
  forgetLights();
  return true;
}
void keep(int slot, vec4 seen) {}
bool mediaAreDue() { return true; }
vec2 firstPlace() { return vec2(0.0); }
void goOnAt(inout float at, inout float wanted) {}
bool lightIsDue(int l) { return true; }
int firstItem() { return 0; }
float firstTau() { return 0.0; }
void foundStep(vec2 step) {}
void foundNothing(vec2 next, bool more) {}
bool pausesAtItem() { return false; }
void itemsDone(int next, float tau) {}
void lightDone(int l) {}
void lightsAgain() {}
void stepDone(vec2 next, bool more) {}
void stretchDone(vec2 next, bool more) {}
void mediaDone() {}
#endif
