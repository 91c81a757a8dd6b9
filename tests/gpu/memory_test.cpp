// How resources share what the device gives.
#include <QtTest>
#include <random>

#include "render/gpu/buffer.h"
#include "render/gpu/check.h"
#include "render/gpu/image.h"
#include "render/gpu/memory_blocks.h"
#include "tests/gpu/gpu_fixture.h"

using namespace render;
using gpu::MemoryBlocks;

class MemoryTest : public QObject {
    Q_OBJECT

    static gpu::Buffer bufferOf(gpu::Device& device, std::uint64_t bytes,
                                gpu::HostAccess host = gpu::HostAccess::Writes) {
        return {device, {"part", bytes, gpu::MemoryUse::Staging, host}};
    }
    static gpu::Image imageOf(gpu::Device& device, std::uint32_t side) {
        return {device, {"picture", VK_FORMAT_R8G8B8A8_UNORM, {side, side}, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT}};
    }

    gpu::Device m_device = std::move(*gpu::Device::create(test::Gpu::get().instance));

    [[nodiscard]] gpu::MemoryReport now() const { return m_device.memoryReport(); }

private slots:
    void init() {
        m_device.inject({});
        m_device.waitIdle();
    }

    void smallResourcesShareBlocks() {
        const std::uint64_t before = now().allocations;
        std::vector<gpu::Buffer> buffers;
        std::vector<gpu::Image> images;
        for (int i = 0; i < 200; ++i) {
            buffers.push_back(bufferOf(m_device, 1000));
            images.push_back(imageOf(m_device, 16));
        }
        QVERIFY(now().allocations <= before + 4);
        QVERIFY(now().heldBytes >= now().total());
        QVERIFY(now().of(gpu::MemoryUse::Staging) >= 200 * 1000);
    }

    /// Blocks grow, so that much takes few of them, and hold no more than what is needed and as much again.
    void blocksGrowWithWhatIsInThem() {
        const gpu::MemoryReport before = now();
        std::vector<gpu::Buffer> buffers;
        for (int i = 0; i < 500; ++i) {
            buffers.push_back(bufferOf(m_device, 100'000));
            const std::uint64_t needed = now().total() - before.total();
            QVERIFY(now().heldBytes - before.heldBytes <= 2 * needed + 2 * MemoryBlocks::kSmallestBlock);
        }
        QVERIFY(now().allocations - before.allocations <= 8);
    }

    void emptyBlocksGoBackButOne() {
        for (int round = 0; round < 3; ++round) {
            std::vector<gpu::Buffer> buffers;
            for (int i = 0; i < 100; ++i) {
                buffers.push_back(bufferOf(m_device, 100'000));
            }
            QVERIFY(now().heldBytes > 4 * MemoryBlocks::kSmallestBlock);
            buffers.clear();
            m_device.waitIdle();
            QCOMPARE(now().total(), std::uint64_t{0});
            QVERIFY(now().heldBytes <= 2 * MemoryBlocks::kSmallestBlock);  // one of buffers, one of images
        }
    }

    void largeResourcesGoBackAtOnce() {
        const gpu::MemoryReport before = now();
        {
            const gpu::Buffer buffer = bufferOf(m_device, MemoryBlocks::kSmallestBlock);
            const gpu::Image image = imageOf(m_device, 1024);
            QCOMPARE(now().allocations, before.allocations + 2);
        }
        m_device.waitIdle();
        QCOMPARE(now().heldBytes, before.heldBytes);
        QCOMPARE(now().allocations, before.allocations);
    }

    /// Blocks come and go, what is in a buffer stays. Of a kind that is read fast: from a card's own memory it took
    /// minutes.
    void neighboursLeaveEachOtherAlone() {
        std::mt19937 dice(7);
        std::vector<std::pair<gpu::Buffer, std::byte>> buffers;
        const auto isWhole = [](const auto& entry) {
            return std::ranges::all_of(entry.first.mapped(), [&](std::byte b) { return b == entry.second; });
        };
        for (int i = 0; i < 2000; ++i) {
            if (buffers.empty() || (i < 1000 ? dice() % 3 != 0 : dice() % 3 == 0)) {
                const std::uint64_t bytes = dice() % 8 == 0 ? dice() % 2'000'000 : dice() % 3000;
                const auto fill = static_cast<std::byte>(dice() & 0xff);
                buffers.emplace_back(bufferOf(m_device, bytes, gpu::HostAccess::Reads), fill);
                QCOMPARE(buffers.back().first.address() % 16, VkDeviceAddress{0});
                std::ranges::fill(buffers.back().first.mapped(), fill);
            } else {
                const std::size_t which = dice() % buffers.size();
                QVERIFY(isWhole(buffers[which]));
                std::swap(buffers[which], buffers.back());
                buffers.pop_back();
            }
            if (i % 50 == 0) {
                m_device.waitIdle();
            }
        }
        QVERIFY(std::ranges::all_of(buffers, isWhole));
    }

    /// A device that is nearly full may have room for a resource and none for a block.
    void withoutRoomForABlockAResourceHasMemoryOfItsOwn() {
        gpu::Device device = std::move(*gpu::Device::create(test::Gpu::get().instance));
        device.inject({.mostBytes = MemoryBlocks::kSmallestBlock / 2});
        const gpu::Buffer first = bufferOf(device, 1000);
        const gpu::Buffer second = bufferOf(device, 1000);
        QVERIFY(!first.mapped().empty());
        QCOMPARE(device.memoryReport().allocations, std::uint64_t{2});
        QCOMPARE(device.memoryReport().heldBytes, device.memoryReport().total());
    }

    void aFaultHitsAResourceWhereItsBlockHasRoom() {
        const gpu::Buffer first = bufferOf(m_device, 1000);
        const std::uint64_t before = now().total();
        m_device.inject({.failAllocation = 2});
        const gpu::Buffer second = bufferOf(m_device, 1000);
        QVERIFY(!second.mapped().empty());
        try {
            const gpu::Buffer third = bufferOf(m_device, 1'500'000);
            QFAIL("no fault");
        } catch (const gpu::OutOfMemory& none) {
            QCOMPARE(none.what, "part (1.5 MB)");
        }
        QVERIFY(now().total() > before);
        QVERIFY(now().total() < before + 10'000);
    }
};

GPU_TEST_MAIN(MemoryTest)
#include "memory_test.moc"
