// Every parser on every truncated prefix of its seeds, and on seeds with a byte changed: it must come back. The
// sanitizer presets run this too.

#include <QtTest>
#include <random>

#include "targets.h"
#include "tests/locations.h"

namespace {

/// All prefixes of short texts; of longer ones this many, evenly spread, and all of the last. With
/// COPPERSCOPE_THOROUGH=1 all of all.
constexpr std::size_t kMostPrefixes = 400;
constexpr std::size_t kLastPrefixes = 64;
constexpr int kChanges = 100;

/// In a buffer of its own, so that a sanitizer sees a read beyond its end.
void runOn(const fuzz::Target& target, std::string_view text) {
    const std::vector<char> copy(text.begin(), text.end());
    target.run({copy.data(), copy.size()});
}

void addTargets() {
    QTest::addColumn<QString>("target");
    for (const fuzz::Target& target : fuzz::targets()) {
        QTest::newRow(target.name) << QString(target.name);
    }
}

const fuzz::Target& fetchTarget() {
    QFETCH(QString, target);
    return *fuzz::findTarget(fuzz::targets(), target.toStdString());
}

}  // namespace

class HostileInputTest : public QObject {
    Q_OBJECT

private slots:
    void everyTargetHasSeeds_data() { addTargets(); }
    void everyTargetHasSeeds() { QVERIFY(!fuzz::seedsOf(fetchTarget()).empty()); }

    void everyTruncatedPrefixIsReadWithoutHarm_data() { addTargets(); }
    void everyTruncatedPrefixIsReadWithoutHarm() {
        const fuzz::Target& target = fetchTarget();
        for (const fuzz::File& seed : fuzz::seedsOf(target)) {
            const std::size_t size = seed.text.size();
            const std::size_t stride = locations::isThorough() ? 1 : std::max<std::size_t>(size / kMostPrefixes, 1);
            for (std::size_t length = 0; length <= size; length += length + kLastPrefixes < size ? stride : 1) {
                runOn(target, std::string_view(seed.text).substr(0, length));
            }
        }
    }

    void changedBytesAreReadWithoutHarm_data() { addTargets(); }
    void changedBytesAreReadWithoutHarm() {
        const fuzz::Target& target = fetchTarget();
        std::mt19937 random(1);
        for (const fuzz::File& seed : fuzz::seedsOf(target)) {
            for (int i = 0; i < kChanges; ++i) {
                std::string text = seed.text;
                text[random() % text.size()] = static_cast<char>(random());
                runOn(target, text);
            }
        }
    }

    void bundlesComeApartAgain() {
        const std::vector<fuzz::File> files = {{"a/b", "one\ntwo\n"}, {"c d", ""}, {"e", "three\n"}};
        const std::vector<fuzz::File> apart = fuzz::unbundle(fuzz::bundle(files));
        QCOMPARE(apart.size(), files.size());
        for (std::size_t i = 0; i < files.size(); ++i) {
            QCOMPARE(apart[i].path, files[i].path);
            QCOMPARE(apart[i].text, files[i].text);
        }
    }
};

QTEST_APPLESS_MAIN(HostileInputTest)
#include "hostile_input_test.moc"
