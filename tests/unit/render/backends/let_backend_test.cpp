#include "render/backends/let_backend.h"

#include <QtTest>

class LetBackendTest : public QObject {
    Q_OBJECT

private slots:
    void everythingHasAThreadWithinWhatAllDevicesTake_data() {
        QTest::addColumn<std::uint32_t>("count");
        for (const std::uint32_t count : {1U, 64U, 65U, 65'536U, 65'537U, 4'194'241U, 100'000'000U, 4'000'000'000U}) {
            QTest::addRow("%u", count) << count;
        }
    }
    void everythingHasAThreadWithinWhatAllDevicesTake() {
        QFETCH(std::uint32_t, count);
        constexpr std::uint32_t kMostOfAll = 65'535;  // Vulkan's smallest maxComputeWorkGroupCount
        const glm::uvec2 groups = render::cullGroups(count);
        QVERIFY(groups.x <= kMostOfAll && groups.y <= kMostOfAll);
        QVERIFY(std::uint64_t{groups.x} * groups.y * shader::kCullGroupSize >= count);
    }

    void nothingHasNoWorkgroups() { QCOMPARE(render::cullGroups(0), glm::uvec2(0)); }
};

QTEST_APPLESS_MAIN(LetBackendTest)
#include "let_backend_test.moc"
