// Small bases over u in [0,1]: projection of optical depth and its analytic integral. Equations:
// docs/physics.md; twins: renderer/shadow/basis.h. BASIS_FLOATS: array length of the variant.
#pragma once
#include "shared/records.h"
const float kPi = 3.14159265358979;

#ifndef BASIS_FLOATS
#define BASIS_FLOATS 8
#endif

// (cos, sin) of the sum of two angles. Orders are counted up with it: its error grows with the order,
// that of the recurrence 2 cos a sin k a - sin (k - 1) a with its square.
vec2 turned(vec2 at, vec2 by) { return vec2(at.x * by.x - at.y * by.y, at.x * by.y + at.y * by.x); }
vec2 turnOf(float angle) { return vec2(cos(angle), sin(angle)); }

// The same for half the width of a step, >= 0: small ones keep their relative precision whatever the
// device's sine does, so that sin(k x)/(k x) needs no other form anywhere.
vec2 halfTurnOf(float x) {
  float y = x * x;
  return vec2(cos(x), y < 0.25 ? x * (1.0 - y / 6.0 * (1.0 - y / 20.0 * (1.0 - y / 42.0))) : sin(x));
}
const float kLeastHalf = 1e-12;  // of a step: sinc is 1 there

// Adds an optical depth m spread evenly over [u0, u1]: c_k += 2 m times the basis function's mean over the
// step. Exact for constant extinction and a linear u, for any step length; no cancellation as u1 -> u0.
void projectStep(int basis, inout float c[BASIS_FLOATS], float m, float u0, float u1) {
  float mid = 0.5 * (u0 + u1), halfWidth = 0.5 * (u1 - u0);
  if (basis == BASIS_COSINE || basis == BASIS_FOURIER) {  // Fourier: a0, a1, b1, a2, b2, ...
    float perOrder = basis == BASIS_COSINE ? kPi : 2.0 * kPi, h = max(perOrder * halfWidth, kLeastHalf);
    vec2 middle = turnOf(perOrder * mid), wide = halfTurnOf(h), at = middle, over = wide;
    float both = 2.0 * m / h;
    c[0] += basis == BASIS_COSINE ? m : 2.0 * m;
    if (basis == BASIS_COSINE) {
      for (int k = 1; k < BASIS_FLOATS; ++k) {
        c[k] += both * (1.0 / float(k)) * over.y * at.x;
        at = turned(at, middle), over = turned(over, wide);
      }
    } else {
      for (int i = 1; i < BASIS_FLOATS; i += 2) {
        float s = both * (1.0 / float((i + 1) / 2)) * over.y;
        c[i] += s * at.x;
        if (i + 1 < BASIS_FLOATS) c[i + 1] += s * at.y;
        at = turned(at, middle), over = turned(over, wide);
      }
    }
  } else {  // linear slabs
    float n = float(BASIS_FLOATS), lo = clamp(u0, 0.0, 1.0) * n, hi = clamp(u1, 0.0, 1.0) * n;
    int first = min(int(lo), BASIS_FLOATS - 1);
    if (hi - lo < 1e-6) {
      c[first] += m;
    } else {
      for (int j = 0; j < BASIS_FLOATS; ++j)
        c[j] += m * max(min(hi, float(j + 1)) - max(lo, float(j)), 0.0) / (hi - lo);
    }
  }
}

// Piecewise cosines: every interval of the metric has its own optical depth and its own cosines, shared out
// in turn: coefficient i belongs to interval i modulo count, order i / count. No interval's detail is paid
// for by another, and each end is exact. Adds m spread over [v0, v1] of interval j.
void projectPiece(inout float c[BASIS_FLOATS], float m, int count, int j, float v0, float v1) {
  float h = max(0.5 * kPi * (v1 - v0), kLeastHalf), both = 2.0 * m / h;
  vec2 middle = turnOf(kPi * 0.5 * (v0 + v1)), wide = halfTurnOf(h), at = vec2(1.0, 0.0), over = at;
  int k = 0, piece = 0;
  for (int i = 0; i < BASIS_FLOATS; ++i) {
    c[i] += piece == j ? (k == 0 ? m : both / float(k) * over.y * at.x) : 0.0;
    ++piece;
    bool wrap = piece == count;
    at = wrap ? turned(at, middle) : at;
    over = wrap ? turned(over, wide) : over;
    k += wrap ? 1 : 0;
    piece = wrap ? 0 : piece;
  }
}

// Optical depth in front of v of interval j: all of the intervals before it, and its own series.
float pieceTau(int n, float c[BASIS_FLOATS], int count, int j, float v) {
  vec2 turn = turnOf(kPi * v), at = vec2(1.0, 0.0);
  float before = 0.0, own = 0.0, within = 0.0;
  int k = 0, piece = 0;
  for (int i = 0; i < BASIS_FLOATS; ++i) {
    if (i >= n) break;
    bool first = k == 0, mine = piece == j;
    before += first && piece < j ? c[i] : 0.0;
    own += first && mine ? c[i] : 0.0;
    within += !mine ? 0.0 : first ? c[i] * v : c[i] * at.y / (float(k) * kPi);
    ++piece;
    bool wrap = piece == count;
    at = wrap ? turned(at, turn) : at;
    k += wrap ? 1 : 0;
    piece = wrap ? 0 : piece;
  }
  return before + clamp(within, 0.0, max(own, 0.0));
}

// What the series need of u before any coefficient: known while the coefficients are still being read.
struct BasisPhase {
  float u, sine, cosine;  // of pi u (cosines) or 2 pi u (Fourier)
};

BasisPhase basisPhase(int basis, float u) {
  float angle = (basis == BASIS_FOURIER ? 2.0 : 1.0) * kPi * u;
  return BasisPhase(u, sin(angle), cos(angle));
}

// tau(u) from n coefficients, clamped to [0, tau(1)].
float basisTau(int basis, int n, float c[BASIS_FLOATS], BasisPhase at) {
  if (basis == BASIS_COSINE) {
    // Odd and even orders side by side: sin (k + 2) a = 2 cos 2a sin k a - sin (k - 2) a, half as long a
    // chain as order by order. Its error grows with k^2, so that every eight orders it begins anew from 8 a,
    // which three doublings give.
    float tau = c[0] * at.u, w = 4.0 * at.cosine * at.cosine - 2.0;
    vec2 one = vec2(at.cosine, at.sine), two = turned(one, one), four = turned(two, two),
         eight = turned(four, four), begun = vec2(1.0, 0.0);
    vec2 previous = vec2(-at.sine, 0.0), current = vec2(at.sine, 2.0 * at.cosine * at.sine);
    for (int k = 1; k < BASIS_FLOATS; k += 2) {
      if (k >= n) break;
      if (k > 1 && k % 8 == 1) {
        begun = turned(begun, eight);
        vec2 along = begun.y * vec2(one.x, two.x), across = begun.x * vec2(one.y, two.y);
        current = along + across;
        previous = vec2(along.x - across.x, begun.y);
      }
      tau += c[k] * current.x * (1.0 / (float(k) * kPi));
      if (k + 1 < n) tau += c[min(k + 1, BASIS_FLOATS - 1)] * current.y * (1.0 / (float(k + 1) * kPi));
      vec2 next = w * current - previous;
      previous = current, current = next;
    }
    return clamp(tau, 0.0, c[0]);
  }
  if (basis == BASIS_FOURIER) {
    float whole = 0.5 * c[0], tau = whole * at.u;
    float cs = at.cosine, sn = at.sine, ck = cs, sk = sn;
    for (int i = 1; i < BASIS_FLOATS; i += 2) {
      if (i >= n) break;
      float perOrder = 1.0 / (float((i + 1) / 2) * 2.0 * kPi);
      tau += c[i] * sk * perOrder;
      if (i + 1 < n) tau += c[min(i + 1, BASIS_FLOATS - 1)] * (1.0 - ck) * perOrder;
      float next = ck * cs - sk * sn;
      sk = sk * cs + ck * sn, ck = next;
    }
    return clamp(tau, 0.0, max(whole, 0.0));
  }
  float tau = 0.0, place = clamp(at.u, 0.0, 1.0) * float(n);
  for (int j = 0; j < BASIS_FLOATS; ++j) {
    if (j >= n) break;
    tau += c[j] * clamp(place - float(j), 0.0, 1.0);
  }
  return tau;
}

// The function itself at u: SUM of coefficients times basis functions (slabs: their density), not integrated.
float basisValue(int basis, int n, float c[BASIS_FLOATS], float u) {
  float value = 0.0;
  if (basis == BASIS_COSINE) {
    vec2 turn = turnOf(kPi * u), at = vec2(1.0, 0.0);
    for (int k = 0; k < BASIS_FLOATS; ++k) {
      if (k >= n) break;
      value += c[k] * at.x;
      at = turned(at, turn);
    }
    return value;
  }
  if (basis == BASIS_FOURIER) {
    value = 0.5 * c[0];
    float cs = cos(2.0 * kPi * u), sn = sin(2.0 * kPi * u), ck = cs, sk = sn;
    for (int i = 1; i < BASIS_FLOATS; i += 2) {
      if (i >= n) break;
      value += c[i] * ck;
      if (i + 1 < n) value += c[min(i + 1, BASIS_FLOATS - 1)] * sk;
      float next = ck * cs - sk * sn;
      sk = sk * cs + ck * sn, ck = next;
    }
    return value;
  }
  int at = clamp(int(u * float(n)), 0, n - 1);
  for (int j = 0; j < BASIS_FLOATS; ++j) value = j == at ? c[j] * float(n) : value;
  return value;
}
