#pragma once
// The smaller and the larger of two numbers.

FUNCTION Real atMost(Real value, Real limit) { return select(value < limit, value, limit); }

FUNCTION Real atLeast(Real value, Real limit) { return select(value > limit, value, limit); }
