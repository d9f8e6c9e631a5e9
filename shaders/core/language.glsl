// The words of the shared arithmetic (shaders/core/*.glsl), as GLSL spells them. src/core/arithmetic.h spells them for
// C++. Rules of the subset: no branch on varying data but select(); loops with uniform bounds; typed literals
// Real(0.5); masks joined by && || !; no fma; own exp and expm1; constants (arrays too) are CONSTANT Scalar, one number
// for all lanes, made Real where they are used. No unary minus of a Real, Real(0.0) - x instead: xsimd's own gives 0 or
// -0 for 0, as the instruction set has it.
// PRECISE marks what an optimiser must not rearrange.
// Tables: a TABLE_FUNCTION takes TABLES as its first parameter, hands WITH_TABLES on, and calls TABLE(fetch)(...), one of
// the few fetch functions that each side supplies. Loops whose length differs between lanes end with
// while (anyLane(mask)); lanes that are done must not change any more. WHERE_ANY(mask) { ... } may be left out where no
// lane needs it: it must change nothing that matters in lanes outside of the mask.
// The lookups (shaders/lookup, segment_color.glsl) are in this subset, too. They may use UNIFORM(T, name), T of Scalar,
// int, Texels and Table2d, Table3d (filter.glsl), and the fetch functions rgbaAt, numberAt, scalarAt; and
// UNIFORM_NUMBERS(name, count), as many Scalars, name[i] with an i that is the same for all lanes.
#define Real float
#define Scalar float
#define Mask bool
#define Int int
#define Rgba vec4
#define FUNCTION
#define INOUT(T) inout T
#define OUT(T) out T
#define CONSTANT const
#define PRECISE precise
#define TABLE_FUNCTION
#define TABLES
#define WITH_TABLES
#define TABLE(fetch) fetch
#define WHERE_ANY(mask)  // a branch would cost more: both of its sides are run
const bool kDouble = false;  // true where Real has 53 bits

Real select(Mask condition, Real yes, Real no) { return mix(no, yes, condition); }

// 2^n for an integral n in [-126, 127].
Real exp2Integral(Real n) { return intBitsToFloat((int(n) + 127) << 23); }
Real roundToIntegral(Real x) { return roundEven(x); }
Real squareRoot(Real x) { return sqrt(x); }
Real absolute(Real x) { return abs(x); }
bool anyLane(Mask mask) { return mask; }
int toInt(Real x) { return int(x); }  // towards zero

#define UNIFORM(T, name) uniform T name
#define UNIFORM_NUMBERS(name, count) uniform float name[count]
#define Texels samplerBuffer
// Texel i; the number of texel i; the same where i is the same for all lanes.
Rgba rgbaAt(Texels texels, Int i) { return texelFetch(texels, i); }
Real numberAt(Texels texels, Int i) { return texelFetch(texels, i).r; }
Scalar scalarAt(Texels texels, int i) { return texelFetch(texels, i).r; }

// What the program was compiled for (RenderPlan::defines).
#ifdef HAVS_CELL_DATA
const bool cellData = true;
#else
const bool cellData = false;
#endif
#ifdef HAVS_OPAQUE_SURFACES
const bool opaqueSurfaces = true;
#else
const bool opaqueSurfaces = false;
#endif
#ifdef HAVS_ISOSURFACES
const bool isosurfaces = true;
#else
const bool isosurfaces = false;
#endif
#ifdef HAVS_LIT
const bool lit = true;
#else
const bool lit = false;
#endif
#define lookupNumber HAVS_LOOKUP_NUMBER
