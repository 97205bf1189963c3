// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_following_h
#define softgrain_mpm_contact_frame_following_h

#include <softgrain/mpm/contact/frame_search.h>

#include <optional>

namespace softgrain::mpm
{
/**
 * @brief Keeps frames of the plane by their contacts in steps with inertia, so that no energy is given when
 * they change.
 *
 * A contact that is narrower than its rays are apart is met by one of them. A disk that rolls or slides would
 * go over each ray as over a step, and lose what it falls.
 */
class FrameFollowing
{
public:
  using Vector = dealii::Tensor<1, 2>;
  using Frame = ContactFrame<2>;

  /// @param scene with FrameScene::halfway
  /// @param apart from the partner to the image that the body meets [m]
  FrameFollowing(const FrameScene<2> &scene, const Vector &apart) : scene(scene), apart(apart) {}

  /// Turns a frame to the normals where its strongest ray stands: there the gap stays what it is.
  void turn(const Vector &direction, Frame &frame) const;

  /// Lets a frame follow a narrow contact of a round body. The gap is least in the middle of the contact. The
  /// strongest ray stands beside the middle; as far on its other side the gap is the same. The ray changes
  /// sides if it will then be nearer to the middle halfway through the step. The frame is turned to the
  /// normals that the middle will have then.
  void follow(Frame &frame) const;

private:
  using Places = std::array<SurfacePlace<2>, 2>;
  /// What the ray 0 meets on both sides.
  struct Met
  {
    double gap = 0;    ///< [m]
    double slope = 0;  ///< of the gap across the rays
    double bend = 0;   ///< of the gap across the rays [1/m]
    double height = 0; ///< mean of both [m]
    Vector normal;     ///< mean of both, unit
  };
  enum class When
  {
    now,
    halfway
  };

  bool at_wall(const Frame &frame) const
  {
    return frame.partner == Frame::none && scene.line_of(frame) == nullptr;
  }
  std::optional<Met> meet_both(const Frame &frame, When when, Places &place) const;
  std::optional<double> find_middle(Frame &frame, When when, Places &place) const;
  void go_to_gap(double guess, Places place, Frame &frame, Met &met) const;
  void turn_about(const Met &met, const Vector &direction, Frame &frame) const;
  bool is_narrow(const Frame &frame, double curvature) const;
  Vector half_carried(unsigned int side, const Frame &frame) const;
  double half_motion(const Frame &frame, const Places &place) const;

  const FrameScene<2> &scene;
  const Vector &apart;
};
} // namespace softgrain::mpm

#endif
