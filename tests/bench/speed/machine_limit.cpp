#include "bench/speed/machine_limit.hpp"

#include <algorithm>
#include <cstring>

namespace moldlight::bench {

namespace {

/// The bits of all items, folded in eight independent chains, so that memory and not the adder sets the pace.
template <typename Item>
std::uint64_t fold(const std::vector<Item>& items) {
  using Words = std::uint64_t __attribute__((vector_size(64)));
  Words folded = {};
  const auto* bytes = reinterpret_cast<const char*>(items.data());
  const std::size_t size = items.size() * sizeof(Item);
  std::size_t at = 0;
  for (; at + sizeof(Words) <= size; at += sizeof(Words)) {
    Words words;
    std::memcpy(&words, bytes + at, sizeof words);
    folded ^= words;
  }
  Words rest = {};
  std::memcpy(&rest, bytes + at, size - at);
  folded ^= rest;
  std::uint64_t result = 0;
  for (int lane = 0; lane < 8; ++lane) result ^= folded[lane];
  return result;
}

}  // namespace

MachineLimit::MachineLimit(const ScanPart& part, int resolution) : part_(part) {
  const std::size_t texels = static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution);
  for (auto& map : maps_) map.resize(texels);
}

std::uint64_t MachineLimit::pass() {
  const std::uint64_t folded = fold(part_.positions()) ^ fold(part_.facets());
  ++passes_;
  for (auto& map : maps_) std::fill(map.begin(), map.end(), folded + passes_);
  return maps_[0][passes_ % maps_[0].size()] ^ maps_[1][passes_ % maps_[1].size()];
}

}  // namespace moldlight::bench
