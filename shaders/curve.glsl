// The fetch functions of core/curve.glsl and core/integral_functions.glsl: the packed curve
// (src/transfer/packed_curve.h) in buffer textures.
uniform samplerBuffer curvePieces;
uniform samplerBuffer curveGuide;
uniform samplerBuffer curveIntegrals;
uniform float guideCells;

float pieceNear(float s) { return texelFetch(curveGuide, int(min(s * guideCells, guideCells - 1.0))).r; }
vec4 piecePlace(float piece) { return texelFetch(curvePieces, 3 * int(piece)); }
vec4 pieceLow(float piece) { return texelFetch(curvePieces, 3 * int(piece) + 1); }
vec4 pieceHigh(float piece) { return texelFetch(curvePieces, 3 * int(piece) + 2); }
vec4 pieceExtinction(float piece) { return texelFetch(curveIntegrals, 3 * int(piece)); }
vec4 lightHead(float piece) { return texelFetch(curveIntegrals, 3 * int(piece) + 1); }
vec4 lightTail(float piece) { return texelFetch(curveIntegrals, 3 * int(piece) + 2); }

#include "core/curve.glsl"
