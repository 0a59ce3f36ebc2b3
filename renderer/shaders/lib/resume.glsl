// llvmpipe ends all loops of an invocation, without a word, once they have run 65535 times in total, nested ones included; the 8 lanes of a
// vector share that count. With RESUME 1 a march counts its own iterations, pauses where its share of them is used up, and leaves what the
// next dispatch goes on from. Each lane may spend an eighth, so that 8 lanes that never wait in the same loop are within the limit too.
#pragma once
#include "shared/resume.h"
#ifndef RESUME
#define RESUME 0
#endif

#if RESUME
struct MarchState {
  vec4 seen;    // radiance so far and T of a picture; the other light of a pair and T of an error pass
  float t;      // where the stretch of the camera ray begins
  int step;     // next one of that stretch
  int light;    // first one whose part in that step is missing
  int item;     // of the light's volumes to march through: the first one that is missing
  float tau;    // of those before it
  int phase;
};
const int kInMedia = 0, kAtSolid = 1, kFinished = 2;
layout(std430, binding = BIND_MARCH_STATES) buffer MarchStates {
  int unfinished, unused_[3];
  MarchState states[];
};
uniform int dispatchIndex;            // 0: begin
uniform int budget;                   // iterations a lane may begin its next piece of work with
// Iterations of a stretch's list, of looking at a step, and of a sample but for its shadow marches.
uniform int stretchCost, stepCost, sampleCost;

MarchState state = MarchState(vec4(0.0, 0.0, 0.0, 1.0), 0.0, 0, 0, 0, 0.0, kInMedia);
int spent = 0;
bool paused = false;

// Is light l still missing, and may it be begun now?
bool lightIsDue(int l) { return l >= state.light && !paused; }
bool mustPause() { return spent >= budget; }

// Behind the search for the next step with something in it: it found none, for the stretch is over or the budget is.
void foundNothing(int next, int count) {
  paused = next < count;
  state.step = next;
  state.light = paused ? 0 : 1 << 30;
}
#define SPEND(iterations) spent += iterations
#else
#define SPEND(iterations)
#endif
