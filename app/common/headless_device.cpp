#include "app/common/headless_device.h"

#include <utility>

namespace app {

base::Result<HeadlessDevice> HeadlessDevice::open() {
    base::Result<render::gpu::Instance> instance = render::gpu::Instance::create({});
    if (!instance) {
        return instance.error();
    }
    base::Result<render::gpu::Device> device = render::gpu::Device::create(*instance);
    if (!device) {
        return device.error();
    }
    return HeadlessDevice{std::make_unique<render::gpu::Instance>(std::move(*instance)),
                          std::make_unique<render::gpu::Device>(std::move(*device))};
}

}  // namespace app
