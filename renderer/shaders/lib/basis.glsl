// Small bases over u in [0,1]: projection of optical depth and its analytic integral. Equations:
// docs/physics.md; twins: renderer/shadow/basis.h. BASIS_FLOATS: array length of the variant.
#pragma once
#include "shared/records.h"
const float kPi = 3.14159265358979;

#ifndef BASIS_FLOATS
#define BASIS_FLOATS 8
#endif

// sin(x)/x for the half width of a step, which is far below 2.5: to 1e-5 there, without a sine.
float sinc(float x) {
  float y = x * x;
  return 1.0 - y / 6.0 * (1.0 - y / 20.0 * (1.0 - y / 42.0 * (1.0 - y / 72.0 * (1.0 - y / 110.0))));
}

// Adds an optical depth m spread evenly over [u0, u1]: c_k += 2 m times the basis function's mean over the
// step. Exact for constant extinction and a linear u, for any step length; no cancellation as u1 -> u0.
void projectStep(int basis, inout float c[BASIS_FLOATS], float m, float u0, float u1) {
  float mid = 0.5 * (u0 + u1), halfWidth = 0.5 * (u1 - u0);
  if (basis == BASIS_COSINE) {
    float th = kPi * mid, w = 2.0 * cos(th), previous = 1.0, current = 0.5 * w;
    c[0] += m;
    for (int k = 1; k < BASIS_FLOATS; ++k) {
      c[k] += 2.0 * m * current * sinc(float(k) * kPi * halfWidth);
      float next = w * current - previous;
      previous = current, current = next;
    }
  } else if (basis == BASIS_FOURIER) {  // a0, a1, b1, a2, b2, ...
    float th = 2.0 * kPi * mid, cs = cos(th), sn = sin(th), ck = cs, sk = sn;
    c[0] += 2.0 * m;
    for (int i = 1; i < BASIS_FLOATS; i += 2) {
      float s = 2.0 * m * sinc(float((i + 1) / 2) * 2.0 * kPi * halfWidth);
      c[i] += s * ck;
      if (i + 1 < BASIS_FLOATS) c[i + 1] += s * sk;
      float next = ck * cs - sk * sn;
      sk = sk * cs + ck * sn, ck = next;
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
  float th = kPi * 0.5 * (v0 + v1), halfWidth = 0.5 * kPi * (v1 - v0);
  float w = 2.0 * cos(th), previous = 0.5 * w, current = 1.0;
  int k = 0, piece = 0;
  for (int i = 0; i < BASIS_FLOATS; ++i) {
    c[i] += piece == j ? (k == 0 ? m : 2.0 * m * current * sinc(float(k) * halfWidth)) : 0.0;
    ++piece;
    bool wrap = piece == count;
    float next = w * current - previous;
    previous = wrap ? current : previous;
    current = wrap ? next : current;
    k += wrap ? 1 : 0;
    piece = wrap ? 0 : piece;
  }
}

// Optical depth in front of v of interval j: all of the intervals before it, and its own series.
float pieceTau(int n, float c[BASIS_FLOATS], int count, int j, float v) {
  float w = 2.0 * cos(kPi * v), previous = 0.0, current = sin(kPi * v), before = 0.0, own = 0.0, within = 0.0;
  int k = 0, piece = 0;
  for (int i = 0; i < BASIS_FLOATS; ++i) {
    if (i >= n) break;
    bool first = k == 0, mine = piece == j;
    before += first && piece < j ? c[i] : 0.0;
    own += first && mine ? c[i] : 0.0;
    within += !mine ? 0.0 : first ? c[i] * v : c[i] * current / (float(k) * kPi);
    ++piece;
    bool wrap = piece == count;
    float next = w * current - previous;
    bool advance = wrap && !first;
    previous = advance ? current : previous;
    current = advance ? next : current;
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
    // chain as order by order.
    float tau = c[0] * at.u, w = 4.0 * at.cosine * at.cosine - 2.0;
    vec2 previous = vec2(-at.sine, 0.0), current = vec2(at.sine, 2.0 * at.cosine * at.sine);
    for (int k = 1; k < BASIS_FLOATS; k += 2) {
      if (k >= n) break;
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
    float w = 2.0 * cos(kPi * u), previous = 0.5 * w, current = 1.0;  // cos(-th), cos(0)
    for (int k = 0; k < BASIS_FLOATS; ++k) {
      if (k >= n) break;
      value += c[k] * current;
      float next = w * current - previous;
      previous = current, current = next;
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
