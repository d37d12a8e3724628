// The same input gives the same maps and the same figures to the bit, whichever headless backend draws them.
#include <vector>

#include <gtest/gtest.h>

#include "gl/headless_context.hpp"
#include "support/classify_mesh.hpp"
#include "support/map_lookup.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

struct DrawnByBackend {
  std::vector<std::uint32_t> plus, minus;
  Classification samples, facet_ids, symmetric;
};

DrawnByBackend draw(gl::HeadlessBackend backend, const test::Shape& shape) {
  const auto context = gl::create_headless_context(backend);
  Classifier classifier(*context, test::model_of(shape.mesh));
  Query query;
  query.direction = shape.direction;
  query.method.resolution = 512;
  query.method.samples = 100'000;
  query.method.readout = Readout::samples;
  DrawnByBackend drawn;
  drawn.samples = classifier.classify(query, Progress{});
  drawn.plus = classifier.maps().read(true);
  drawn.minus = classifier.maps().read(false);
  query.method.readout = Readout::facet_id;
  drawn.facet_ids = classifier.classify(query, Progress{});
  query.method.readout = Readout::samples;
  query.method.kernel_shape = KernelShape::symmetric;
  drawn.symmetric = classifier.classify(query, Progress{});
  return drawn;
}

TEST(Backends, AgreeToTheBit) {
  for (const test::Shape& shape : {test::snap_hook({}), test::spool({}), test::cup_with_side_hole({})}) {
    const DrawnByBackend egl = draw(gl::HeadlessBackend::egl, shape);
    const DrawnByBackend osmesa = draw(gl::HeadlessBackend::osmesa, shape);
    ASSERT_NE(egl.samples.backend, osmesa.samples.backend);
    EXPECT_EQ(egl.plus, osmesa.plus) << shape.name;
    EXPECT_EQ(egl.minus, osmesa.minus) << shape.name;
    EXPECT_GT(std::count_if(egl.plus.begin(), egl.plus.end(), [](auto texel) { return texel != 0; }), 1000);
    for (const auto member :
         {&DrawnByBackend::samples, &DrawnByBackend::facet_ids, &DrawnByBackend::symmetric}) {
      EXPECT_EQ((egl.*member).facet_fractions, (osmesa.*member).facet_fractions) << shape.name;
      EXPECT_EQ((egl.*member).areas.values, (osmesa.*member).areas.values) << shape.name;
      EXPECT_EQ((egl.*member).uncertainty.total(), (osmesa.*member).uncertainty.total()) << shape.name;
      EXPECT_EQ((egl.*member).identity.core, (osmesa.*member).identity.core) << shape.name;
    }
  }
}

}  // namespace
}  // namespace moldlight
