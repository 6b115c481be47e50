#include "output/front_view.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "output/whole_file.h"

namespace similitude {
namespace {

static_assert(std::endian::native == std::endian::little, "front_view.bin is little-endian");

constexpr char k_mark[] = {'S', 'I', 'M', 'F', 'R', 'O', 'N', 'T'};
constexpr std::uint32_t k_version = 1;
constexpr std::size_t k_picture_header = 24, k_row = 6;    // [bytes]
constexpr double k_places_per_radius = 3;                  // of the grid that tells what is hidden
constexpr double k_most_places = 4e6;                      // of that grid
constexpr double k_least_visible = 0.15;                   // share of a disc that must show for the particle to be drawn
constexpr double k_same_time = 1e-9;                       // relative

template <class T>
void put(std::vector<char>& bytes, T value) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(T));
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

template <class T>
T get(const std::vector<char>& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

/// `value` of 0 ... 1 as a whole number of 0 ... `most`.
template <class T>
T share(double value, double most) {
  return static_cast<T>(std::lround(std::clamp(value, 0.0, 1.0) * most));
}

/// 0 ... 1, evenly spread over ids: Knuth's multiplicative hash, The Art of Computer Programming 3, section 6.4.
double spread(std::uint64_t id) {
  return static_cast<double>((id * 0x9e3779b97f4a7c15u) >> 11) * 0x1p-53;
}

void append(const std::filesystem::path& file, const std::vector<char>& bytes, std::ios::openmode mode) {
  std::ofstream stream(file, std::ios::binary | mode);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.flush();
  if (!stream) throw_output_error(file, "written", errno);
}

}  // namespace

std::vector<char> read_front_view(const std::filesystem::path& folder) {
  std::ifstream stream(folder / k_front_view_file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

FrontViewIndex front_view_index(const std::vector<char>& bytes) {
  FrontViewIndex index;
  if (bytes.size() < k_front_view_header || !std::equal(std::begin(k_mark), std::end(k_mark), bytes.begin()) ||
      get<std::uint32_t>(bytes, sizeof k_mark) != k_version)
    return index;
  std::size_t at = k_front_view_header;
  while (at + k_picture_header <= bytes.size()) {
    const std::size_t end = at + k_picture_header + k_row * get<std::uint32_t>(bytes, at + 20);
    if (end > bytes.size()) break;  // the run was killed while it wrote this one
    index.pictures.push_back({at, end, get<double>(bytes, at)});
    at = end;
  }
  return index;
}

FrontView::FrontView(const OutputDirectory& directory, const MapBack& map_back, double width, double height,
                     std::optional<double> after)
    : file_(directory.file(k_front_view_file)), map_(map_back), width_(width), height_(height) {
  if (after) {
    const FrontViewIndex index = front_view_index(read_front_view(directory.path()));
    std::size_t keep = index.pictures.empty() ? 0 : k_front_view_header;
    for (const FrontViewIndex::Picture& picture : index.pictures)
      if (picture.time <= *after * (1 + k_same_time)) keep = picture.end;
    if (keep > 0) {
      std::error_code error;
      std::filesystem::resize_file(file_, keep, error);
      if (error) throw_output_error(file_, "shortened", error.value());
      return;
    }
  }
  bytes_.assign(std::begin(k_mark), std::end(k_mark));
  put(bytes_, k_version);
  put(bytes_, std::uint32_t{0});
  put(bytes_, width_);
  put(bytes_, height_);
  append(file_, bytes_, std::ios::trunc);
}

/// Nearest to the front wall first; ids decide between equals, so that the order of rows does not show.
void FrontView::take(const ParticleStore& particles) {
  grains_.clear();
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const Row& p = particles.position[k];
    const Row& v = particles.velocity[k];
    const Grain grain{map_.length(p.x), map_.length(p.y), map_.length(p.z), map_.length(p.w),
                      map_.velocity(std::hypot(v.x, v.y, v.z)), particles.id[k]};
    if (grain.x >= 0 && grain.x <= width_ && grain.z >= 0 && grain.z <= height_) grains_.push_back(grain);
  }
  std::sort(grains_.begin(), grains_.end(),
            [](const Grain& a, const Grain& b) { return a.y != b.y ? a.y < b.y : a.id < b.id; });
}

/// Discs on a grid of places, the nearest first: who finds enough of its places taken is hidden.
void FrontView::leave_the_visible() {
  double smallest = HUGE_VAL;
  for (const Grain& grain : grains_) smallest = std::min(smallest, grain.radius);
  const double place = std::max(smallest / k_places_per_radius, std::sqrt(width_ * height_ / k_most_places));
  const auto columns = static_cast<long>(width_ / place) + 1, rows = static_cast<long>(height_ / place) + 1;
  covered_.assign(static_cast<std::size_t>(columns * rows), 0);
  std::erase_if(grains_, [&](const Grain& grain) {
    long all = 0, free = 0;
    const auto each = [&](auto&& what) {
      const auto first_row = std::max(0L, static_cast<long>((grain.z - grain.radius) / place));
      const auto last_row = std::min(rows - 1, static_cast<long>((grain.z + grain.radius) / place));
      for (long row = first_row; row <= last_row; ++row) {
        const double dz = (static_cast<double>(row) + 0.5) * place - grain.z;
        const double half = std::sqrt(std::max(0.0, grain.radius * grain.radius - dz * dz));
        const auto first = std::max(0L, static_cast<long>((grain.x - half) / place));
        const auto last = std::min(columns - 1, static_cast<long>((grain.x + half) / place));
        for (long column = first; column <= last; ++column) what(covered_[static_cast<std::size_t>(row * columns + column)]);
      }
    };
    each([&](std::uint8_t& taken) { ++all, free += taken == 0 ? 1 : 0; });
    if (static_cast<double>(free) <= k_least_visible * static_cast<double>(all)) return true;
    each([](std::uint8_t& taken) { taken = 1; });
    return false;
  });
}

void FrontView::add(const ParticleStore& particles, double time) {
  take(particles);
  double fastest = 0, largest = 0;
  for (const Grain& grain : grains_) {
    fastest = std::max(fastest, grain.speed);
    largest = std::max(largest, grain.radius);
  }
  if (!grains_.empty()) leave_the_visible();
  const double drawn = std::min(1.0, static_cast<double>(k_front_view_rows) / std::max<double>(1, static_cast<double>(grains_.size())));
  std::erase_if(grains_, [&](const Grain& grain) { return spread(grain.id) >= drawn; });

  bytes_.clear();
  put(bytes_, map_.time(time));
  put(bytes_, static_cast<float>(fastest));
  put(bytes_, static_cast<float>(largest));
  put(bytes_, static_cast<float>(drawn));
  put(bytes_, static_cast<std::uint32_t>(grains_.size()));
  for (auto grain = grains_.rbegin(); grain != grains_.rend(); ++grain) {
    put(bytes_, share<std::uint16_t>(grain->x / width_, 65535));
    put(bytes_, share<std::uint16_t>(grain->z / height_, 65535));
    put(bytes_, share<std::uint8_t>(fastest > 0 ? std::sqrt(grain->speed / fastest) : 0, 255));
    put(bytes_, share<std::uint8_t>(grain->radius / largest, 255));
  }
  append(file_, bytes_, std::ios::app);
}

}  // namespace similitude
