// Every target on its seeds while memory is refused, once and for good, at one request after another: what runs comes
// back or says so with std::bad_alloc, and nothing that was taken is left.

#include <QtTest>

#include "tests/counted_memory.h"
#include "tests/fuzz/targets.h"
#include "tests/locations.h"

namespace {

/// Of a seed that asks for more: all of the first, then evenly spread. With COPPERSCOPE_THOROUGH=1 all.
constexpr std::size_t kFirstRequests = 40;
constexpr std::size_t kMostRequests = 100;
constexpr std::size_t kMostSeeds = 3;  // the shortest

/// Read JSON with nlohmann's library, whose values ask for memory when they go: where there is none the program ends,
/// with a message (app/common/memory_limit.cpp), and so would this test.
constexpr std::array<std::string_view, 8> kWithJson = {
    "kicad_rules",         "kicad_project", "gerber_job_file", "gerber_job",
    "kicad_project_rules", "rules",         "waivers",         "session"};

/// CGAL, which this one calls, does not give back all that it had where memory ran out in the middle of it.
constexpr std::string_view kWithCgal = "contours";

/// What comes out: true for a normal end, false where memory ran out. Anything else that is thrown is an error.
bool runOn(const fuzz::Target& target, std::string_view text) {
    try {
        target.run(text);
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

std::vector<fuzz::File> shortSeeds(const fuzz::Target& target) {
    std::vector<fuzz::File> seeds = fuzz::seedsOf(target);
    std::ranges::stable_sort(seeds, {}, [](const fuzz::File& seed) { return seed.text.size(); });
    seeds.resize(std::min(seeds.size(), kMostSeeds));
    return seeds;
}

std::size_t stepAfter(std::size_t request, std::size_t all) {
    const bool isEach = request < kFirstRequests || locations::isThorough();
    return isEach ? 1 : std::max<std::size_t>((all - kFirstRequests) / (kMostRequests - kFirstRequests), 1);
}

}  // namespace

class ScarceMemoryTest : public QObject {
    Q_OBJECT

private slots:
    void whatRunsOutOfMemorySaysSoAndKeepsNothing_data() {
        QTest::addColumn<QString>("name");
        for (const fuzz::Target& target : fuzz::targets()) {
            if (std::ranges::find(kWithJson, target.name) != kWithJson.end()) {
                continue;
            }
            QTest::newRow(target.name) << QString(target.name);
        }
    }
    void whatRunsOutOfMemorySaysSoAndKeepsNothing() {
        QFETCH(QString, name);
        const fuzz::Target& target = *fuzz::findTarget(fuzz::targets(), name.toStdString());
        for (const fuzz::File& seed : shortSeeds(target)) {
            QVERIFY(runOn(target, seed.text));  // what is made once and stays is there now
            const std::size_t before = counted::memory().allocations;
            QVERIFY(runOn(target, seed.text));
            const std::size_t requests = counted::memory().allocations - before;
            for (std::size_t request = 1; request <= requests; request += stepAfter(request, requests)) {
                for (const bool isLasting : {false, true}) {
                    refuse(target, seed, request, isLasting);
                    if (QTest::currentTestFailed()) {
                        return;
                    }
                }
            }
        }
    }

    void cleanupTestCase() {
        qInfo("faults injected: %zu requests for memory refused, %zu of them said", m_refused, m_told);
        QVERIFY(m_told > m_refused / 2);
    }

private:
    void refuse(const fuzz::Target& target, const fuzz::File& seed, std::size_t request, bool isLasting) {
        const std::size_t before = counted::memory().live;
        bool isDone = false;
        bool hasRefused = false;
        {
            const counted::Refusal refusal(request, isLasting);
            isDone = runOn(target, seed.text);
            hasRefused = refusal.hasRefused();
        }
        const std::size_t after = counted::memory().live;
        m_refused += hasRefused ? 1 : 0;
        m_told += isDone ? 0 : 1;
        QVERIFY2(after == before || target.name == kWithCgal,
                 qPrintable(QString("%1, request %2%3: %4 bytes are left")
                                .arg(QString::fromStdString(seed.path))
                                .arg(request)
                                .arg(isLasting ? " and all after it" : "")
                                .arg(static_cast<qint64>(after) - static_cast<qint64>(before))));
    }

    std::size_t m_refused = 0;
    std::size_t m_told = 0;
};

QTEST_APPLESS_MAIN(ScarceMemoryTest)
#include "scarce_memory_test.moc"
