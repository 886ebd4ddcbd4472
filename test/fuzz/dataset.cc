// Scenes of data sets. The first byte tells the layout; then come the files of a scene, each after
// its length in two bytes; a file of no bytes is left out.
#include "evaluation/dataset.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fuzzer/FuzzedDataProvider.h>

#include "fuzz/expectations.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

struct Layout {
  const char* scene;
  std::vector<const char*> files;
};

const std::array<Layout, 4>& Layouts() {
  static const std::array<Layout, 4> layouts = {
      {{"v3",
        {"v3/im0.png", "v3/im1.png", "v3/disp0GT.pfm", "v3/mask0nocc.png", "v3/normals0.pfm",
         "v3/calib.txt"}},
       {"2003", {"2003/im2.ppm", "2003/im6.ppm", "2003/disp2.pgm", "2003/disp6.pgm"}},
       {"2006", {"2006/view1.png", "2006/view5.png", "2006/disp1.png", "2006/disp5.png"}},
       {"kitti/image_2/0_10.png",
        {"kitti/image_2/0_10.png", "kitti/image_3/0_10.png", "kitti/disp_noc_0/0_10.png"}}}};
  return layouts;
}

// Where the scenes lie: folders that exist, without files.
const TemporaryFolder& Root() {
  static const TemporaryFolder root;
  static const bool made = [] {
    for (const Layout& layout : Layouts()) {
      for (const std::filesystem::path file : layout.files) {
        std::filesystem::create_directories(root.Path(file.parent_path().string()));
      }
    }
    return true;
  }();
  Expect(made, "folders");
  return root;
}

void WriteFiles(const Layout& layout, FuzzedDataProvider* input) {
  for (const char* file : layout.files) {
    const std::string bytes = input->ConsumeBytesAsString(input->ConsumeIntegral<std::uint16_t>());
    const std::string path = Root().Path(file);
    if (bytes.empty()) {
      std::filesystem::remove(path);
    } else {
      std::ofstream(path, std::ios::binary) << bytes;
    }
  }
}

void CheckScene(const StereoScene& scene) {
  Expect(!scene.left.empty() && scene.left.size() == scene.right.size(), "a pair of one size");
  Expect(scene.disparity.type() == CV_32FC1 && scene.disparity.size() == scene.left.size(),
         "ground truth for each pixel");
  Expect(scene.mask.empty() || scene.mask.size() == scene.left.size(), "a mask of that size");
  Expect(scene.normals.empty() || scene.normals.size() == scene.left.size(),
         "normals of that size");
}

}  // namespace
}  // namespace stereo_sgmp

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stereo_sgmp;
  FuzzedDataProvider input(data, size);
  const Layout& layout = Layouts()[input.ConsumeIntegralInRange<std::size_t>(0, 3)];
  WriteFiles(layout, &input);
  StereoScene scene;
  if (Reads([&] { scene = LoadScene(Root().Path(layout.scene)); })) CheckScene(scene);
  return 0;
}
