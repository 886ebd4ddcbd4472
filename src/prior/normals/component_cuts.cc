#include "prior/normals/component_cuts.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "prior/normals/normal_integration.h"

namespace stereo_sgmp {
namespace {

// An edge is where the image changes by so much more than over the component. Surfaces that spread
// meet on ridges of noise and texture, too.
constexpr double kMinContrast = 1.3;

// How much the image changes at some pixels.
struct Change {
  std::int64_t sum = 0;
  std::int64_t count = 0;

  void Add(int change) {
    sum += change;
    ++count;
  }
  double Mean() const { return static_cast<double>(sum) / static_cast<double>(count); }
};

using Part = std::pair<int, schar>;  // a component and a label in it

// Which labels of the components belong together.
class Parts {
 public:
  Parts(const cv::Mat_<int>& component, const cv::Mat_<schar>& label, const cv::Mat_<uchar>& edges)
      : component_(component), label_(label), edges_(edges) {
    for (int y = 0; y < component_.rows; ++y) SeeRow(y);
    for (const auto& [border, change] : along_) {
      const auto [id, low, high] = border;
      if (change.Mean() <= kMinContrast * over_.at(id).Mean()) Join({id, low}, {id, high});
    }
  }

  // The one that stands for all that belong to `part`.
  Part RootOf(Part part) const {
    for (auto found = joined_.find(part); found != joined_.end(); found = joined_.find(part)) {
      part.second = found->second;
    }
    return part;
  }

 private:
  void SeeRow(int y) {
    int id = 0;
    Change* over = nullptr;
    for (int x = 0; x < component_.cols; ++x) {
      if (component_(y, x) == 0) continue;
      if (component_(y, x) != id) {
        id = component_(y, x);
        over = &over_[id];
      }
      over->Add(edges_(y, x));
      if (x > 0) SeeBorder({x, y}, {x - 1, y});
      if (y > 0) SeeBorder({x, y}, {x, y - 1});
    }
  }

  void SeeBorder(cv::Point p, cv::Point q) {
    if (label_(p) == label_(q) || component_(p) != component_(q)) return;
    const auto [low, high] = std::minmax(label_(p), label_(q));
    // Both pixels beside an edge see it.
    along_[{component_(p), low, high}].Add(std::min(edges_(p), edges_(q)));
  }

  void Join(Part a, Part b) {
    a = RootOf(a);
    b = RootOf(b);
    if (a != b) joined_[b] = a.second;
  }

  const cv::Mat_<int>& component_;
  const cv::Mat_<schar>& label_;
  const cv::Mat_<uchar>& edges_;
  std::unordered_map<int, Change> over_;  // of components
  std::map<std::tuple<int, schar, schar>, Change> along_;
  std::map<Part, schar> joined_;
};

}  // namespace

cv::Mat_<int> CutComponents(const cv::Mat_<int>& component, const cv::Mat_<schar>& label,
                            const cv::Mat_<uchar>& edges) {
  const Parts parts(component, label, edges);
  cv::Mat_<int> cut(component.size(), 0);
  std::map<Part, int> numbers;
  std::unordered_map<int, int> parts_of_cell;
  Part last{0, schar{0}};
  int number = 0;
  for (int y = 0; y < cut.rows; ++y) {
    for (int x = 0; x < cut.cols; ++x) {
      if (component(y, x) == 0) continue;
      const Part here{component(y, x), label(y, x)};
      if (here != last) {
        last = here;
        const auto [found, is_new] = numbers.emplace(parts.RootOf(here), 0);
        if (is_new) {
          const int cell = IntegratedNormals::CellOf(here.first);
          found->second = 1 + cell * IntegratedNormals::kCellArea + parts_of_cell[cell]++;
        }
        number = found->second;
      }
      cut(y, x) = number;
    }
  }
  return cut;
}

}  // namespace stereo_sgmp
