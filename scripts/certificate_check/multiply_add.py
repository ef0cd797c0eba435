# SPDX-License-Identifier: GPL-2.0-or-later
"""The header's fused multiply-adds: that what carries them out is the text below."""

from certificate_check.sines import squeezed

TEXT = r"""
namespace detail {
void fma();  // hides the functions of the library; one that returns a number is none for such scalars
template <class Scalar>
struct MultiplyAdd {
  template <class S>
  static S of(const S& a, const S& b, const S& c, int decltype(fma(a, b, c))::*) noexcept {
    return S(fma(a, b, c));
  }
  template <class S>
  static S of(const S& a, const S& b, const S& c, ...) noexcept {
    return a * b + c;
  }
  Scalar operator()(const Scalar& a, const Scalar& b, const Scalar& c) const noexcept {
    return of(a, b, c, nullptr);
  }
};
template <>
struct MultiplyAdd<double> {
  [[gnu::always_inline]] double operator()(double a, double b, double c) const noexcept {
#if defined(__FMA__) || defined(__aarch64__) || defined(__FP_FAST_FMA) || \
    (defined(__ARM_FEATURE_FMA) && (__ARM_FP & 8)) || (defined(__riscv_flen) && __riscv_flen >= 64)
    return std::fma(a, b, c);
#else
    return a * b + c;
#endif
  }
};
template <>
struct MultiplyAdd<float> {
  [[gnu::always_inline]] float operator()(float a, float b, float c) const noexcept {
#if defined(__FMA__) || defined(__aarch64__) || defined(__FP_FAST_FMAF) || \
    (defined(__ARM_FEATURE_FMA) && (__ARM_FP & 4)) || (defined(__riscv_flen) && __riscv_flen >= 32)
    return std::fma(a, b, c);
#else
    return a * b + c;
#endif
  }
};
}
"""


def faults(header):
    """What is wrong with the operation fma of the header, if it has any."""
    text = squeezed(header.text)
    if "MultiplyAdd" in text and (text.count(squeezed(TEXT)) != 1 or text.count("struct MultiplyAdd") != 3):
        yield "the header's fused multiply-adds are not those that flatdyn writes"
