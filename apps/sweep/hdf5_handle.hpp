#pragma once

#include <hdf5.h>
#include <string>
#include <utility>

#include "linkwright/sweep/sweep_table.hpp"

namespace linkwright {

/// One of HDF5's identifiers, closed by the function that goes with its kind. Below 0: there is none.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Hdf5Handle() { reset(); }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    reset();
    id_ = std::exchange(other.id_, -1);
    close_ = other.close_;
    return *this;
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  [[nodiscard]] hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  /// False where closing fails, which is when the last bytes are written.
  bool reset() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// HDF5 tells nobody but us, and leaves nothing to do for the end of the program.
inline void quiet_hdf5() {
  static const bool once = [] {
    ::H5dont_atexit();
    return ::H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
  }();
  static_cast<void>(once);
}

/// UTF-8 text of a fixed width, padded with zeros, or of any.
inline Hdf5Handle text_type(std::size_t width) {
  Hdf5Handle type(::H5Tcopy(H5T_C_S1), ::H5Tclose);
  ::H5Tset_size(type.id(), width);
  ::H5Tset_strpad(type.id(), width == H5T_VARIABLE ? H5T_STR_NULLTERM : H5T_STR_NULLPAD);
  ::H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

/// Type of a column in memory; in the file it is that of a little-endian machine.
inline Hdf5Handle memory_type(const SweepColumn& column) {
  switch (column.kind) {
    case ColumnKind::number:
      return {::H5Tcopy(H5T_NATIVE_DOUBLE), ::H5Tclose};
    case ColumnKind::count:
      return {::H5Tcopy(H5T_NATIVE_INT64), ::H5Tclose};
    case ColumnKind::flag:
      return {::H5Tcopy(H5T_NATIVE_UINT8), ::H5Tclose};
    default:
      return text_type(column.width);
  }
}

inline Hdf5Handle file_type(const SweepColumn& column) {
  switch (column.kind) {
    case ColumnKind::number:
      return {::H5Tcopy(H5T_IEEE_F64LE), ::H5Tclose};
    case ColumnKind::count:
      return {::H5Tcopy(H5T_STD_I64LE), ::H5Tclose};
    case ColumnKind::flag:
      return {::H5Tcopy(H5T_STD_U8LE), ::H5Tclose};
    default:
      return text_type(column.width);
  }
}

}  // namespace linkwright
