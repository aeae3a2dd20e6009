#include "linkwright/mechanism/pose.hpp"

namespace linkwright {

std::string pattern(const std::vector<PrescribedPose>& poses) {
  std::string text;
  for (const PrescribedPose& pose : poses) {
    if (!text.empty()) text += '-';
    text.append(static_cast<std::size_t>(pose.multiplicity()), 'P');
  }
  return text;
}

int position_count(const std::vector<PrescribedPose>& poses) {
  int count = 0;
  for (const PrescribedPose& pose : poses) count += pose.multiplicity();
  return count;
}

}  // namespace linkwright
