#pragma once
/// Three numbers of one kind: doubles, or packs of a block's rows. Header-only; includes nothing of the framework.

namespace similitude {

template <class V>
struct Vec3 {
  V x, y, z;
};

template <class V>
constexpr Vec3<V> operator+(const Vec3<V>& a, const Vec3<V>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <class V>
constexpr Vec3<V> operator-(const Vec3<V>& a, const Vec3<V>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <class V>
constexpr Vec3<V> operator-(const Vec3<V>& a) { return {-a.x, -a.y, -a.z}; }
template <class V, class S>
constexpr Vec3<V> operator*(const S& s, const Vec3<V>& a) { return {s * a.x, s * a.y, s * a.z}; }
template <class V>
constexpr V dot(const Vec3<V>& a, const Vec3<V>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class V>
constexpr Vec3<V> cross(const Vec3<V>& a, const Vec3<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace similitude
