#pragma once

#include <string>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"
#include "model/geometry/discretise.h"

namespace app {

/// How far a picture of the hybrid pipeline differs from one of the standard pipeline.
struct PictureAgreement {
    std::string view;
    double greyMse = 0.0;  ///< as render::greyMse
};

/// From above, from below, from the corner, and closer to the middle, each with 1000 × 1000 pixels, bodies of
/// components left out. Errors: DeviceFailed.
[[nodiscard]] base::Result<std::vector<PictureAgreement>> comparePictures(const model::Document& document,
                                                                          const model::Discretisation& how,
                                                                          base::Progress& progress);

}  // namespace app
