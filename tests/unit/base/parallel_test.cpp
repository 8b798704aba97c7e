#include "base/parallel.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/array.h"

namespace vbgpd {
namespace {

TEST(Workers, VisitEveryChunkOnce) {
  for (int threads : {1, 2, 4}) {
    Workers workers(threads);
    const Workers::Session session(workers);
    for (int round = 0; round < 200; ++round) {
      std::vector<int> visits(37, 0);
      workers.run(0, 1, 37, [&](int k) { ++visits[static_cast<std::size_t>(k)]; });
      for (int v : visits) EXPECT_EQ(v, 1);
    }
  }
}

TEST(Workers, HonourTheStride) {
  Workers workers(2);
  const Workers::Session session(workers);
  std::vector<int> visits(11, 0);
  workers.run(1, 2, 11, [&](int k) { ++visits[static_cast<std::size_t>(k)]; });
  for (std::size_t k = 0; k < visits.size(); ++k) EXPECT_EQ(visits[k], k % 2 == 1 ? 1 : 0);
}

TEST(Array, AbsentHasNoBytes) {
  Array a;
  EXPECT_FALSE(a.present());
  EXPECT_EQ(a.bytes(), 0u);
  EXPECT_EQ(a.data(), nullptr);
}

TEST(Array, CopiesItsValues) {
  Array a;
  a.allocate(100, 3);
  a[42] = 7;
  Array b = a;
  b[42] = 8;
  EXPECT_EQ(a[42], 7);
  EXPECT_EQ(b.size(), 100u);
}

}  // namespace
}  // namespace vbgpd
