#include "render/backends/measured_backends.h"

#include <QtTest>

#include "model/text/whole_file.h"
#include "tests/full_disk.h"
#include "tests/unit/render/gpu/cache_owner.h"

using namespace render;

class MeasuredBackendsTest : public QObject {
    Q_OBJECT

    static constexpr MeasuredBackends kMeasured{Backend::Raster, Backend::Impostor};

    MeasuredBackendsFile file(const gpu::PipelineCacheOwner& whose = owner()) const {
        return {m_folder.path().toStdString(), whose};
    }

    QTemporaryDir m_folder;

private slots:
    void cleanup() { QDir(m_folder.path()).removeRecursively(), QDir().mkpath(m_folder.path()); }

    void textsGoThereAndBack() {
        for (const Backend plain : {Backend::Auto, Backend::Raster, Backend::Pull, Backend::Mesh, Backend::Impostor}) {
            for (const Backend smoothed : {Backend::Auto, Backend::Pull, Backend::Mesh, Backend::Impostor}) {
                const MeasuredBackends measured{plain, smoothed};
                const auto parsed = parseMeasured(measuredText(measured, owner()), owner());
                QVERIFY(parsed && *parsed == measured);
            }
        }
    }

    void peopleCanReadIt() {
        QCOMPARE(measuredText(kMeasured, owner()),
                 std::string("Copperscope's fastest back ends, version 1\n"
                             "vendor 000010de, device 00002204, driver 4, driver version 00000007, "
                             "09090909090909090909090909090909\nplain: raster\nsmoothed: impostor\n"));
    }

    void damagedTextsAreNone() {
        const std::string text = measuredText(kMeasured, owner());
        for (std::size_t at = 0; at < text.size(); ++at) {
            QVERIFY(!parseMeasured(text.substr(0, at), owner()));
            std::string flipped = text;
            flipped[at] ^= 0x01;
            QVERIFY(!parseMeasured(flipped, owner()));
        }
        QVERIFY(!parseMeasured(text + "\n", owner()));
    }

    void whatCannotSmoothIsNoAnswer() {
        QVERIFY(!parseMeasured(measuredText({Backend::Pull, Backend::Raster}, owner()), owner()));
        QVERIFY(!parseMeasured(measuredText({Backend::Standard, Backend::Pull}, owner()), owner()));
    }

    void otherVersionsAreNone() {
        std::string text = measuredText(kMeasured, owner());
        const std::string version = "version 1\n";
        text.replace(text.find(version), version.size(), "version 0\n");
        QVERIFY(!parseMeasured(text, owner()));
    }

    void whatWasSavedIsLoaded() {
        const MeasuredBackendsFile nested(m_folder.path().toStdString() + "/not/there", owner());
        QVERIFY(!nested.load());
        QVERIFY(nested.save(kMeasured));
        QVERIFY(nested.load() == kMeasured);
        QVERIFY(nested.save({}));
        QVERIFY(nested.load() == MeasuredBackends{});
        nested.remove();
        QVERIFY(!nested.load());
    }

    void anotherVersionOfTheDriverIsMeasuredAgain() {
        QVERIFY(file().save(kMeasured));
        gpu::PipelineCacheOwner newer = owner();
        newer.driverVersion = 8;
        gpu::PipelineCacheOwner rebuilt = owner();
        rebuilt.cacheUuid[3] = 1;
        QVERIFY(!file(newer).load() && !file(rebuilt).load());
        gpu::PipelineCacheOwner secondCard = owner();
        secondCard.device = 1;
        QVERIFY(file(secondCard).save({Backend::Pull, Backend::Pull}));
        QVERIFY(file().load() == kMeasured);
        QVERIFY(file(newer).save({Backend::Mesh, Backend::Mesh}));
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files).size(), 2);
    }

    void withoutAFolderNothingIsKnown() {
        const MeasuredBackendsFile nowhere({}, owner());
        QVERIFY(!nowhere.load());
        QVERIFY(!nowhere.save(kMeasured));
        nowhere.remove();
    }

    void foldersThatCannotBeMadeAreAnError() {
        const auto taken = std::filesystem::path(m_folder.path().toStdString()) / "taken";
        QVERIFY(model::writeWholeFile(taken, "a file"));
        const MeasuredBackendsFile blocked(taken, owner());
        QVERIFY(!blocked.load());
        QCOMPARE(blocked.save(kMeasured).error().code, base::ErrorCode::OutputFailed);
    }

    void whatIsNoFileIsNotRead() {
        std::filesystem::create_directory(file().path());
        QVERIFY(!file().load());
        QVERIFY(!file().save(kMeasured));
    }

    void largeFilesAreNotRead() {
        QVERIFY(model::writeWholeFile(file().path(), std::string(100'000, ' ')));
        QVERIFY(!file().load());
    }

    void fullDisksKeepWhatIsThere() {
        QVERIFY(file().save(kMeasured));
        const base::Status status = [&] {
            const FullDisk disk(16);
            return file().save({});
        }();
        QVERIFY(!status);
        QVERIFY(file().load() == kMeasured);
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    }
};

QTEST_APPLESS_MAIN(MeasuredBackendsTest)
#include "measured_backends_test.moc"
