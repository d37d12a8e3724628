// Real parts whose parting direction is known.
#pragma once

#include <glm/vec3.hpp>

namespace moldlight::test {

struct KnownPull {
  const char* file;
  glm::dvec3 direction;  // unit
};

inline constexpr KnownPull k_shared_pulls[] = {
    {"lego_brick_2x4.stl", glm::dvec3(0, 0, 1)},
    {"m5_stackchan_basecover.stl", glm::dvec3(0, 0, 1)},
    {"m5_stackchan_basecover_tilted.stl", glm::dvec3(0.36, 0.48, 0.8)},
    {"so101_trigger.stl", glm::dvec3(0, 0, 1)},
    {"m5_base26_main.stl", glm::dvec3(0, 0, 1)},
    {"odri_hip_cover_64k.stl", glm::dvec3(0, 0, 1)},
    {"odri_pulley_t30_output.stl", glm::dvec3(0, 0, 1)},
    {"m5_building_block_link.stl", glm::dvec3(0, 0, 1)},
    {"so100_lego_gauge.stl", glm::dvec3(0, 0, 1)},
    {"m5_rfid2_face_shell.stl", glm::dvec3(0, 0, 1)},
    {"numpystl_rear_case.stl", glm::dvec3(0, 1, 0)}};

inline constexpr KnownPull k_demo_pulls[] = {{"enclosure_lid.stl", glm::dvec3(0, 0, 1)},
                                             {"bottle_cap.stl", glm::dvec3(0, 0, 1)},
                                             {"cable_clip.stl", glm::dvec3(0, 1, 0)},
                                             {"tilted_bracket.stl", glm::dvec3(0.48, -0.36, 0.8)}};

}  // namespace moldlight::test
