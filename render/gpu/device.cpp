#include "render/gpu/device.h"

#include <spdlog/spdlog.h>

#include <future>
#include <numeric>
#include <vector>

#include "model/base/background.h"
#include "render/gpu/check.h"
#include "render/gpu/deferred_destroy.h"
#include "render/gpu/device_select.h"
#include "render/gpu/memory_blocks.h"
#include "render/gpu/pipeline_store.h"

namespace render::gpu {

std::uint64_t MemoryReport::total() const {
    return std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0});
}

Device::State::State() = default;

Device::State::~State() {
    if (handle == VK_NULL_HANDLE) {
        return;
    }
    vkDeviceWaitIdle(handle);  // a lost device is idle too: its result changes nothing here
    pipelines.reset();
    if (deferred != nullptr) {
        deferred->collectAll();
    }
    memory.reset();
    vkDestroySemaphore(handle, timeline, nullptr);
    savePipelineCache();
    vkDestroyPipelineCache(handle, pipelineCache, nullptr);
    vkDestroyDevice(handle, nullptr);
}

VkResult Device::State::createDevice(DeviceThreads threads) {
    Features features(choice.caps.hasMeshShader);
    for (const auto& [name, isWanted] : features.needed()) {
        *isWanted = VK_TRUE;
    }
    features.mesh.taskShader = VK_TRUE;
    features.mesh.meshShader = VK_TRUE;
    features.v12.shaderBufferInt64Atomics = choice.caps.hasAtomic64 ? VK_TRUE : VK_FALSE;
    features.core.features.shaderInt64 = choice.caps.hasAtomic64 ? VK_TRUE : VK_FALSE;
    features.core.features.sampleRateShading = choice.caps.canShadeSamples ? VK_TRUE : VK_FALSE;

    std::vector<const char*> extensions;
    if (choice.hasSwapchain) {
        extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    }
    if (choice.caps.hasMeshShader) {
        extensions.push_back(VK_EXT_MESH_SHADER_EXTENSION_NAME);
    }
    const float priority = 1.0F;
    auto queueInfo = vkInfo<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queueInfo.queueFamilyIndex = choice.queueFamily;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;
    auto info = vkInfo<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    info.pNext = &features.core;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queueInfo;
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    const auto create = [&] { return vkCreateDevice(choice.physical, &info, nullptr, &handle); };
    if (!choice.caps.isCpu || threads == DeviceThreads::Equal) {
        return create();
    }
    // Its threads are like the one that makes it.
    return std::async(std::launch::async,
                      [&create] {
                          base::becomeBackground();
                          return create();
                      })
        .get();
}

void Device::State::createObjects(bool hasDebugUtils) {
    vkGetDeviceQueue(handle, choice.queueFamily, 0, &queue);
    if (hasDebugUtils) {
        const auto find = [this](auto& function, const char* name) {
            function =
                reinterpret_cast<std::remove_reference_t<decltype(function)>>(vkGetInstanceProcAddr(instance, name));
        };
        find(setName, "vkSetDebugUtilsObjectNameEXT");
        find(beginLabel, "vkCmdBeginDebugUtilsLabelEXT");
        find(endLabel, "vkCmdEndDebugUtilsLabelEXT");
    }
    auto type = vkInfo<VkSemaphoreTypeCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO);
    type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
    auto semaphore = vkInfo<VkSemaphoreCreateInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO);
    semaphore.pNext = &type;
    VK_CHECK(vkCreateSemaphore(handle, &semaphore, nullptr, &timeline));
    createPipelineCache();
    memory = std::make_unique<MemoryBlocks>(choice.physical, handle);
    deferred = std::make_unique<DeferredDestroy>(handle);
    pipelines = std::make_unique<PipelineStore>();
}

void Device::State::createPipelineCache() {
    cacheFile = std::make_unique<PipelineCacheFile>(pipelineCacheFolder(), choice.caps.cacheOwner);
    const std::string saved = cacheFile->load();
    auto info = vkInfo<VkPipelineCacheCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO);
    info.initialDataSize = saved.size();
    info.pInitialData = saved.data();
    if (!saved.empty() && vkCreatePipelineCache(handle, &info, nullptr, &pipelineCache) == VK_SUCCESS) {
        return;
    }
    info.initialDataSize = 0;
    info.pInitialData = nullptr;
    VK_CHECK(vkCreatePipelineCache(handle, &info, nullptr, &pipelineCache));
}

void Device::State::savePipelineCache() {
    std::size_t size = 0;
    if (isLost || pipelineCache == VK_NULL_HANDLE ||
        vkGetPipelineCacheData(handle, pipelineCache, &size, nullptr) != VK_SUCCESS) {
        return;
    }
    std::string data(size, '\0');
    if (vkGetPipelineCacheData(handle, pipelineCache, &size, data.data()) != VK_SUCCESS) {
        return;
    }
    data.resize(size);
    if (const base::Status status = cacheFile->save(data); !status) {
        spdlog::debug("Compiled pipelines are not kept: {}", status.error().text);
    }
}

base::Result<Device> Device::create(const Instance& instance, VkSurfaceKHR presentTo, DeviceThreads threads) {
    ASSIGN_OR_RETURN(DeviceChoice choice, chooseDevice(instance.handle(), presentTo));
    auto state = std::make_unique<State>();
    state->choice = choice;
    state->choice.hasSwapchain = choice.hasSwapchain && instance.hasSurfaces();
    state->instance = instance.handle();
    const Caps& caps = state->choice.caps;
    if (const VkResult result = state->createDevice(threads); result != VK_SUCCESS) {
        state->handle = VK_NULL_HANDLE;
        return base::Error{base::ErrorCode::DeviceFailed,
                           "The Vulkan device " + caps.name + " could not be opened: " + toString(result) + "."};
    }
    state->createObjects(instance.hasDebugUtils());
    spdlog::debug("Vulkan device: {} ({}), mesh shaders: {}", caps.name, caps.driver, caps.hasMeshShader);
    return Device(std::move(state));
}

MemoryReport Device::memoryReport() const {
    return memory().report();
}

bool Device::mayAllocate(std::uint64_t bytes) {
    Faults& faults = m_state->faults;
    const bool isFault = faults.failAllocation == 1;
    faults.failAllocation -= faults.failAllocation > (faults.failsFromThere ? 1U : 0U) ? 1 : 0;
    return !isFault && isWithinLimits(bytes);
}

bool Device::isWithinLimits(std::uint64_t bytes) const {
    const std::uint64_t ordered = faults().mostBytes;
    return bytes <= caps().maxAllocationBytes && (ordered == 0 || bytes <= ordered);
}

bool Device::canPresentTo(VkSurfaceKHR surface) const {
    return m_state->choice.hasSwapchain && canPresent(physical(), queueFamily(), surface);
}

bool Device::noteLoss(VkResult result) {
    if (result == VK_ERROR_DEVICE_LOST) {
        markLost();
    }
    return result == VK_ERROR_DEVICE_LOST;
}

std::uint64_t Device::submit(const Submission& submission) {
    if (m_state->faults.loseAtSubmission > 0 && --m_state->faults.loseAtSubmission == 0) {
        markLost();
    }
    if (isLost()) {
        return 0;
    }
    auto commands = vkInfo<VkCommandBufferSubmitInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO);
    commands.commandBuffer = submission.commands;
    auto wait = vkInfo<VkSemaphoreSubmitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO);
    wait.semaphore = submission.waitFor;
    wait.stageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT | VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    VkSemaphoreSubmitInfo signals[] = {vkInfo<VkSemaphoreSubmitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO),
                                       vkInfo<VkSemaphoreSubmitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO)};
    signals[0].semaphore = m_state->timeline;
    signals[0].value = m_state->submitted + 1;
    signals[0].stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    signals[1].semaphore = submission.signal;
    signals[1].stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    auto info = vkInfo<VkSubmitInfo2>(VK_STRUCTURE_TYPE_SUBMIT_INFO_2);
    info.waitSemaphoreInfoCount = submission.waitFor != VK_NULL_HANDLE ? 1 : 0;
    info.pWaitSemaphoreInfos = &wait;
    info.commandBufferInfoCount = submission.commands != VK_NULL_HANDLE ? 1 : 0;
    info.pCommandBufferInfos = &commands;
    info.signalSemaphoreInfoCount = submission.signal != VK_NULL_HANDLE ? 2 : 1;
    info.pSignalSemaphoreInfos = signals;
    const VkResult result = vkQueueSubmit2(queue(), 1, &info, VK_NULL_HANDLE);
    if (noteLoss(result)) {
        return 0;
    }
    VK_CHECK(result);
    deferred().noteSubmission(++m_state->submitted);
    return m_state->submitted;
}

VkResult Device::State::waitFor(std::uint64_t number, std::uint64_t patienceNs) {
    if (faults.loseAtWait > 0 && --faults.loseAtWait == 0) {
        return VK_ERROR_DEVICE_LOST;
    }
    auto info = vkInfo<VkSemaphoreWaitInfo>(VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO);
    info.semaphoreCount = 1;
    info.pSemaphores = &timeline;
    info.pValues = &number;
    return vkWaitSemaphores(handle, &info, patienceNs);
}

bool Device::wait(std::uint64_t number) {
    if (isLost()) {
        return false;
    }
    const VkResult result = m_state->waitFor(number, ~std::uint64_t{0});
    if (noteLoss(result)) {
        return false;
    }
    VK_CHECK(result);
    deferred().collect(number);
    return true;
}

bool Device::isDone(std::uint64_t number, std::uint64_t patienceNs) {
    if (isLost()) {
        return false;
    }
    const VkResult result = m_state->waitFor(number, patienceNs);
    if (noteLoss(result) || result == VK_TIMEOUT) {
        return false;
    }
    VK_CHECK(result);
    return true;
}

void Device::waitIdle() {
    const VkResult result = vkDeviceWaitIdle(handle());
    if (!noteLoss(result)) {
        VK_CHECK(result);
    }
    deferred().collectAll();
}

void Device::name(VkObjectType type, std::uint64_t object, std::string_view label) const {
    if (m_state->setName == nullptr) {
        return;
    }
    const std::string text(label);
    auto info = vkInfo<VkDebugUtilsObjectNameInfoEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT);
    info.objectType = type;
    info.objectHandle = object;
    info.pObjectName = text.c_str();
    VK_CHECK(m_state->setName(handle(), &info));
}

void Device::beginLabel(VkCommandBuffer commands, const char* label) const {
    if (m_state->beginLabel != nullptr) {
        auto info = vkInfo<VkDebugUtilsLabelEXT>(VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT);
        info.pLabelName = label;
        m_state->beginLabel(commands, &info);
    }
}

void Device::endLabel(VkCommandBuffer commands) const {
    if (m_state->endLabel != nullptr) {
        m_state->endLabel(commands);
    }
}

}  // namespace render::gpu
