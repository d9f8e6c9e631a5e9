#pragma once
#include <array>
#include <span>

#include "image/image.h"

namespace havs {

/// Mean structural similarity of each of the four channels, 1 for equal ones: Wang, Bovik, Sheikh, Simoncelli, Image
/// Quality Assessment: From Error Visibility to Structural Similarity (IEEE TIP 2004), section III.B: Gaussian window
/// of 11 x 11, sigma 1.5, weights of sum 1; K1 0.01, K2 0.03, range 1; the mean over the windows that lie wholly in the
/// picture (as in the authors' program and scikit-image with gaussian_weights, use_sample_covariance=False; OpenCV's
/// QualitySSIM goes on beyond the border by reflection). Along a side shorter than 11 pixels every pixel is a centre
/// and the window is cut at the border, its weights scaled to sum 1. `mask`: centres not 0 are left out; not a number
/// where none is left. The pictures must be of one size, not empty, finite.
std::array<double, 4> structuralSimilarity(const Image& a, const Image& b, std::span<const unsigned char> mask = {});

}  // namespace havs
