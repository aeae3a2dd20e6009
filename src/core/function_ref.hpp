#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace linkwright {

/// A function that is called while the caller waits, by reference: for parameters, never to keep. Two pointers, where
/// std::function copies what it holds and brings code of its own for each lambda.
template <class Signature>
class FunctionRef;

template <class Return, class... Arguments>
class FunctionRef<Return(Arguments...)> {
 public:
  template <class Function>
  requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef> &&
           std::is_invocable_r_v<Return, const std::remove_reference_t<Function>&, Arguments...>)
      FunctionRef(Function&& function)
      : function_(std::addressof(function)), call_([](const void* held, Arguments... arguments) -> Return {
          return (*static_cast<const std::remove_reference_t<Function>*>(held))(std::forward<Arguments>(arguments)...);
        }) {}

  Return operator()(Arguments... arguments) const { return call_(function_, std::forward<Arguments>(arguments)...); }

 private:
  const void* function_;
  Return (*call_)(const void*, Arguments...);
};

}  // namespace linkwright
