#include <gtest/gtest.h>

#include "smoothing/any_kernel.h"

namespace vbgpd {
namespace {

template <class K>
class EveryKernel : public testing::Test {};
template <class V>
struct Types;
template <class... K>
struct Types<std::variant<K...>> {
  using Listed = testing::Types<K...>;
};
TYPED_TEST_SUITE(EveryKernel, Types<AnyKernel>::Listed);

TYPED_TEST(EveryKernel, IntegratesToOne) {
  const Real h = 0.7;
  const int n = 20000;
  Real sum = 0;
  for (int k = 0; k < n; ++k) {  // midpoint rule over rings
    const Real r = (k + 0.5) * 2 * h / n;
    sum += 2 * kPi * r * TypeParam::value(r, h) * 2 * h / n;
  }
  EXPECT_NEAR(sum, 1, 1e-8);
}

TYPED_TEST(EveryKernel, DerivativeIsTheSlope) {
  const Real h = 0.7;
  for (Real r : {0.1, 0.5, 0.69, 0.9, 1.2, 1.39}) {
    const Real e = 1e-6;
    EXPECT_NEAR(TypeParam::derivative(r, h), (TypeParam::value(r + e, h) - TypeParam::value(r - e, h)) / (2 * e), 1e-7);
  }
}

TYPED_TEST(EveryKernel, VanishesOutsideItsSupport) {
  EXPECT_EQ(TypeParam::value(1.4, 0.7), 0);
  EXPECT_EQ(TypeParam::derivative(2.0, 0.7), 0);
  EXPECT_GT(TypeParam::value(1.399, 0.7), 0);
}

TYPED_TEST(EveryKernel, IsFoundByItsName) {
  const auto found = kernel_by_name(TypeParam::name);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(std::holds_alternative<TypeParam>(*found));
}

TEST(KernelByName, KnowsNoOtherNames) { EXPECT_FALSE(kernel_by_name("gaussian").has_value()); }

}  // namespace
}  // namespace vbgpd
