#include "simulation/scene/ModelRows.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

/// Two bodies of the world, the second with a body of its own.
Model rowsModel(const std::string& prefix, const std::string& range, int user) {
  const auto name = [&](const char* own) { return " name='" + prefix + own + "'"; };
  auto model = compileModel("<mujoco><size nuser_geom='" + std::to_string(user) +
                                "'/><worldbody><geom size='1'/><body><geom size='1'/></body><body" +
                                name("b") + "><freejoint/><geom" + name("g") + " size='1' user='" +
                                (user ? "7" : "") + "'/><body><joint limited='true' range='" +
                                range + "'/><geom size='0.5'/></body></body></worldbody></mujoco>",
                            "test");
  EXPECT_TRUE(model) << model.error().text();
  return std::move(*model);
}

TEST(ModelRows, BelowABody) {
  const Model model = rowsModel("", "0 90", 1);
  const ModelRows rows = ModelRows::below(*model, 2);
  EXPECT_EQ(rows[ModelKind::body], (std::vector{2, 3}));
  EXPECT_EQ(rows[ModelKind::geom], (std::vector{2, 3}));
  EXPECT_EQ(rows[ModelKind::joint], (std::vector{0, 1}));
  EXPECT_EQ(rows[ModelKind::dof].size(), 7u);
  EXPECT_EQ(rows[ModelKind::position].size(), 8u);
  EXPECT_TRUE(rows.has(ModelKind::body, 3));
  EXPECT_FALSE(rows.has(ModelKind::body, 1));
  EXPECT_EQ(ModelRows::all(*model)[ModelKind::geom].size(), 4u);
}

TEST(ModelRows, NumbersAreCopiedOnlyIfTheyDiffer) {
  const Model alone = rowsModel("", "0 90", 1), same = rowsModel("x/", "0 90", 1),
              other = rowsModel("x/", "0 30", 3);
  const ModelRows rows = ModelRows::below(*alone, 2);
  OfModelKinds<int> first;
  first[ModelKind::body] = 2;
  first[ModelKind::geom] = 2;
  NumberCopy unchanged{*alone, rows, *same, first, "x/"};
  EXPECT_TRUE(unchanged.fits());
  EXPECT_FALSE(unchanged.copy());
  NumberCopy changed{*alone, rows, *other, first, "x/"};
  EXPECT_TRUE(changed.fits());
  EXPECT_TRUE(changed.copy());
  EXPECT_EQ(other->jnt_range[3], alone->jnt_range[3]);
  EXPECT_EQ(other->geom_user[3 * 2], 7) << "in rows of another width";
  EXPECT_FALSE((NumberCopy{*alone, rows, *other, first, "y/"}.fits())) << "other names";
  first[ModelKind::body] = 1;
  EXPECT_FALSE((NumberCopy{*alone, rows, *other, first, "x/"}.fits())) << "other bodies";
}

}  // namespace
}  // namespace gt
