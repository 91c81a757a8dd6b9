#include "app/common/headless_device.h"

#include <utility>

#include "app/common/memory_limit.h"

namespace app {

base::Result<HeadlessDevice> HeadlessDevice::open() {
    RETURN_IF_ERROR(checkRoomForDevice());
    ASSIGN_OR_RETURN(render::gpu::Instance instance, render::gpu::Instance::create({}));
    ASSIGN_OR_RETURN(render::gpu::Device device, render::gpu::Device::create(instance));
    return HeadlessDevice{std::make_unique<render::gpu::Instance>(std::move(instance)),
                          std::make_unique<render::gpu::Device>(std::move(device))};
}

base::Result<DeviceTriangulator> DeviceTriangulator::open() {
    ASSIGN_OR_RETURN(HeadlessDevice opened, HeadlessDevice::open());
    auto triangulator = std::make_unique<tri::gpu::Triangulator>(*opened.device);
    return DeviceTriangulator{std::move(opened), std::move(triangulator)};
}

}  // namespace app
