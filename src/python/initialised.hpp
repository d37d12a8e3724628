// Objects that Python made without their __init__ (`Part.__new__(Part)`) hold no value: to use one raises
// TypeError. pybind11 2.10 alone would hand out memory that nothing was written to.
#pragma once

#include <fmt/format.h>
#include <pybind11/pybind11.h>

namespace moldlight::python {

/// The classes of the module: those that say so by a member type, and any that is named here, before it is
/// converted.
template <typename Type>
inline constexpr bool k_bound = requires {
  typename Type::BoundToPython;
};

}  // namespace moldlight::python

namespace pybind11::detail {

template <typename Bound>
requires moldlight::python::k_bound<Bound>
class type_caster<Bound> : public type_caster_base<Bound> {
 public:
  bool load(handle source, bool convert) {
    if (isinstance<Bound>(source) &&
        reinterpret_cast<instance*>(source.ptr())->get_value_and_holder().value_ptr() == nullptr) {
      throw type_error(
          fmt::format("this moldlight.{} holds nothing: it was made without its __init__, as by __new__",
                      static_cast<std::string>(str(type::of(source).attr("__name__")))));
    }
    return type_caster_base<Bound>::load(source, convert);
  }
};

}  // namespace pybind11::detail
