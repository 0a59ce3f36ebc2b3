// The pseudometric u(x): the fraction of the covered length in front of x. Twins: renderer/shadow/metric.h.
// METRIC_FLOATS: array length of the variant (2 K for intervals, the coefficient count otherwise; at least
// 4). WEIGHTS 1: intervals count by a weight each.
#pragma once
#include "shared/records.h"
#include "lib/basis.glsl"

#ifndef METRIC_FLOATS
#define METRIC_FLOATS 8
#endif
#ifndef WEIGHTS
#define WEIGHTS 0
#endif
const int kIntervals = METRIC_FLOATS / 2;

// Antiderivative F of basis function i of g' at t: a box that covers [a,b] adds F(b) - F(a) to coefficient i.
float metricFace(int metric, int i, float t) {
  if (i == 0) return metric == METRIC_FOURIER ? 2.0 * t : t;
  if (metric == METRIC_COSINE) return 2.0 * sin(float(i) * kPi * t) / (float(i) * kPi);
  float k = float((i + 1) / 2), w = 2.0 * kPi * k * t;
  return (i % 2 == 1 ? sin(w) : 1.0 - cos(w)) / (kPi * k);
}

// Intervals (a0, b0, a1, b1, ...), sorted and disjoint; unused ones have a = b = 1. Their weights w are at
// least 1/255^4.
float intervalMass(float m[METRIC_FLOATS], float w[kIntervals], int j) {
#if WEIGHTS
  return w[j] * (m[2 * j + 1] - m[2 * j]);
#else
  return m[2 * j + 1] - m[2 * j];
#endif
}

float intervalWhole(float m[METRIC_FLOATS], float w[kIntervals]) {
  float whole = 0.0;
  for (int j = 0; j < kIntervals; ++j) whole += intervalMass(m, w, j);
  return whole;
}

// As many intervals, with about the same shares of u: then it is only their places that may differ.
bool intervalsAlike(float m[METRIC_FLOATS], float w[kIntervals], float o[METRIC_FLOATS],
                    float v[kIntervals]) {
  bool alike = true;
  for (int j = 0; j < kIntervals; ++j)
    alike = alike && (m[2 * j + 1] > m[2 * j]) == (o[2 * j + 1] > o[2 * j]);
#if WEIGHTS
  float a = max(intervalWhole(m, w), 1e-14), b = max(intervalWhole(o, v), 1e-14);
  for (int j = 0; j < kIntervals; ++j)
    alike = alike && abs(intervalMass(m, w, j) / a - intervalMass(o, v, j) / b) <= 0.1;
#endif
  return alike;
}

// May the metrics of neighbouring texels be blended? Not when an interval of one has no counterpart in the
// other: ends further apart than the shorter one is long, or shares of u that differ by more than a tenth
// (measured on 76 clouds: limits of 0.1, 0.5 and 1 of the length give mean errors of 0.0197, 0.0197 and
// 0.0199, and the last tells apart the fewest texels).
bool intervalsMatch(float m[METRIC_FLOATS], float w[kIntervals], float o[METRIC_FLOATS],
                    float v[kIntervals]) {
  bool match = intervalsAlike(m, w, o, v);
  for (int j = 0; j < kIntervals; ++j) {
    float shorter = min(m[2 * j + 1] - m[2 * j], o[2 * j + 1] - o[2 * j]);
    match = match && max(abs(m[2 * j] - o[2 * j]), abs(m[2 * j + 1] - o[2 * j + 1])) <= 1.0 * shorter;
  }
  return match;
}

// Where a surface is slanted against the light, the short intervals of neighbours lie further apart than they
// are long. Two that are alike belong together when each end of `o` is about where the line from `before`, on
// the other side of `m`, through `m` leads to. A silhouette is a jump that no neighbour leads to.
bool intervalsLead(float before[METRIC_FLOATS], float m[METRIC_FLOATS], float o[METRIC_FLOATS]) {
  bool lead = true;
  for (int j = 0; j < kIntervals; ++j) {
    float shorter = min(m[2 * j + 1] - m[2 * j], o[2 * j + 1] - o[2 * j]);
    vec2 from = vec2(before[2 * j], before[2 * j + 1]), here = vec2(m[2 * j], m[2 * j + 1]),
         to = vec2(o[2 * j], o[2 * j + 1]), bend = abs(to - 2.0 * here + from);
    lead = lead && (here.y > here.x) == (from.y > from.x) &&
           all(lessThanEqual(bend, max(0.25 * abs(to - here), vec2(shorter))));
  }
  return lead;
}

float intervalU(float m[METRIC_FLOATS], float w[kIntervals], float x) {
  float g = 0.0, whole = 0.0;
  for (int j = 0; j < kIntervals; ++j) {
    float width = m[2 * j + 1] - m[2 * j], passed = clamp(x - m[2 * j], 0.0, width);
#if WEIGHTS
    g += w[j] * passed;
    whole += w[j] * width;
#else
    g += passed;
    whole += width;
#endif
  }
  return whole > 1e-14 ? min(g / whole, 1.0) : 0.0;
}

float pieceBegin(float m[METRIC_FLOATS], int j) {
  float a = m[0];
  for (int k = 1; k < kIntervals; ++k) a = k == j ? m[2 * k] : a;
  return a;
}
float pieceEnd(float m[METRIC_FLOATS], int j) {
  float b = m[1];
  for (int k = 1; k < kIntervals; ++k) b = k == j ? m[2 * k + 1] : b;
  return b;
}

// The last interval that begins at or before x (the first one where none does), where x lies in it, and how
// many there are.
void pieceOf(float m[METRIC_FLOATS], float x, out int count, out int j, out float v) {
  count = 0, j = 0;
  float a = m[0], b = m[1];
  for (int k = 0; k < kIntervals; ++k) {
    bool used = m[2 * k + 1] > m[2 * k];
    bool here = used && (k == 0 || m[2 * k] <= x);
    count += used ? 1 : 0;
    j = here ? k : j;
    a = here ? m[2 * k] : a;
    b = here ? m[2 * k + 1] : b;
  }
  count = max(count, 1);
  v = clamp((x - a) / max(b - a, 1e-9), 0.0, 1.0);
}

// Where the last interval ends; 0 without any.
float intervalsEnd(float m[METRIC_FLOATS]) {
  float end = 0.0;
  for (int j = 0; j < kIntervals; ++j) end = m[2 * j + 1] > m[2 * j] ? max(end, m[2 * j + 1]) : end;
  return end;
}

// g = c_0 x + SUM_k c_k sin(pi k x)/(pi k), u = g / c_0 clamped: overshoot of the truncated series beyond
// [0,1] is real.
float cosineU(float m[METRIC_FLOATS], int n, float x) {
  float g = m[0] * x;
  vec2 turn = turnOf(kPi * x), at = turn;
  for (int k = 1; k < METRIC_FLOATS; ++k) {
    if (k >= n) break;
    g += m[k] * at.y / (float(k) * kPi);
    at = turned(at, turn);
  }
  return m[0] > 1e-6 ? clamp(g / m[0], 0.0, 1.0) : 0.0;
}

// Series a0, a1, b1, a2, b2, ...: g = a0/2 x + SUM_k [a_k sin(2 pi k x) + b_k (1 - cos(2 pi k x))]/(2 pi k).
float fourierU(float m[METRIC_FLOATS], int n, float x) {
  float whole = 0.5 * m[0], g = whole * x;
  float cs = cos(2.0 * kPi * x), sn = sin(2.0 * kPi * x), c = cs, s = sn;
  for (int i = 1; i < METRIC_FLOATS; i += 2) {
    if (i >= n) break;
    float k = float((i + 1) / 2) * 2.0 * kPi;
    g += m[i] * s / k;
    if (i + 1 < n) g += m[min(i + 1, METRIC_FLOATS - 1)] * (1.0 - c) / k;
    float next = c * cs - s * sn;
    s = s * cs + c * sn, c = next;
  }
  return whole > 1e-6 ? clamp(g / whole, 0.0, 1.0) : 0.0;
}

float metricU(int metric, int n, float m[METRIC_FLOATS], float w[kIntervals], float x) {
  if (metric == METRIC_INTERVAL) return intervalU(m, w, x);
  if (metric == METRIC_COSINE) return cosineU(m, n, x);
  if (metric == METRIC_FOURIER) return fourierU(m, n, x);
  return x;
}
