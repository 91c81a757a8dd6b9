#pragma once

namespace render::gpu {

/// How long the device took for a stage of a frame; stages of one name are added up.
struct StageTime {
    const char* name = "";
    double ms = 0.0;
};

}  // namespace render::gpu
