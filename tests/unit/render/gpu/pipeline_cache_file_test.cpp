#include "render/gpu/pipeline_cache_file.h"

#include <QtTest>

#include "model/text/whole_file.h"
#include "tests/full_disk.h"
#include "tests/unit/render/gpu/cache_owner.h"

using namespace render::gpu;

class PipelineCacheFileTest : public QObject {
    Q_OBJECT

    static std::string compiled(char fill) { return std::string(1000, fill); }

    /// What a file that was written and then spoilt gives back.
    template <class Spoil>
    std::string loadSpoilt(const Spoil& spoil) {
        PipelineCacheFile file(m_folder.path().toStdString(), owner());
        [&] { QVERIFY(file.save(compiled('a'))); }();
        std::string bytes = model::readWholeFile(file.path()).value();
        spoil(bytes);
        [&] { QVERIFY(model::writeWholeFile(file.path(), bytes)); }();
        return PipelineCacheFile(m_folder.path().toStdString(), owner()).load();
    }

    QTemporaryDir m_folder;

private slots:
    void cleanup() { QDir(m_folder.path()).removeRecursively(), QDir().mkpath(m_folder.path()); }

    void whatWasSavedIsLoaded() {
        const auto folder = std::filesystem::path(m_folder.path().toStdString()) / "not" / "there";
        PipelineCacheFile file(folder, owner());
        QCOMPARE(file.load(), std::string());
        QVERIFY(file.save(compiled('a')));
        QCOMPARE(PipelineCacheFile(folder, owner()).load(), compiled('a'));
        QVERIFY(file.save(compiled('b')));
        QCOMPARE(PipelineCacheFile(folder, owner()).load(), compiled('b'));
    }

    void spoiltFilesAreLeftAlone() {
        QCOMPARE(loadSpoilt([](std::string&) {}), compiled('a'));
        QCOMPARE(loadSpoilt([](std::string& bytes) { bytes.clear(); }), std::string());
        for (const std::size_t size : {1U, 63U, 64U, 65U, 1063U}) {
            QCOMPARE(loadSpoilt([&](std::string& bytes) { bytes.resize(size); }), std::string());
        }
        QCOMPARE(loadSpoilt([](std::string& bytes) { bytes += 'a'; }), std::string());
        for (std::size_t at = 0; at < 1064; at += at < 64 ? 1 : 50) {
            QCOMPARE(loadSpoilt([&](std::string& bytes) { bytes[at] ^= 0x20; }), std::string());
        }
    }

    void cachesOfOthersAreLeftAlone() {
        const auto folder = m_folder.path().toStdString();
        QVERIFY(PipelineCacheFile(folder, owner()).save(compiled('a')));
        PipelineCacheOwner newer = owner();
        newer.driverVersion = 8;
        PipelineCacheOwner rebuilt = owner();
        rebuilt.cacheUuid[3] = 1;
        for (const PipelineCacheOwner& other : {newer, rebuilt}) {
            PipelineCacheFile file(folder, other);
            QCOMPARE(file.load(), std::string());
        }
        PipelineCacheOwner secondCard = owner();
        secondCard.device = 1;
        PipelineCacheOwner secondDriver = owner();
        secondDriver.driver = 3;
        for (const PipelineCacheOwner& other : {secondCard, secondDriver}) {
            QVERIFY(PipelineCacheFile(folder, other).save(compiled('c')));
        }
        QCOMPARE(PipelineCacheFile(folder, owner()).load(), compiled('a'));
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files).size(), 3);
        QVERIFY(PipelineCacheFile(folder, newer).save(compiled('b')));
        QCOMPARE(PipelineCacheFile(folder, newer).load(), compiled('b'));
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files).size(), 3);
    }

    void nothingIsWrittenWithoutNeed() {
        PipelineCacheFile file(m_folder.path().toStdString(), owner());
        QVERIFY(file.save(std::string(PipelineCacheFile::kEmptyBytes, 'h')));
        QVERIFY(file.save(std::string(PipelineCacheFile::kMostBytes + 1, 'x')));
        QVERIFY(!std::filesystem::exists(file.path()));
        QVERIFY(file.save(compiled('a')));
        PipelineCacheFile next(m_folder.path().toStdString(), owner());
        QCOMPARE(next.load(), compiled('a'));
        std::filesystem::remove(next.path());
        QVERIFY(next.save(compiled('a')));
        QVERIFY(!std::filesystem::exists(next.path()));
    }

    void withoutAFolderNothingIsKept() {
        PipelineCacheFile file({}, owner());
        QVERIFY(file.save(compiled('a')));
        QCOMPARE(file.load(), std::string());
    }

    void fullDisksKeepWhatIsThere() {
        PipelineCacheFile file(m_folder.path().toStdString(), owner());
        QVERIFY(file.save(compiled('a')));
        const base::Status status = [&] {
            const FullDisk disk(4096);
            return file.save(std::string(100'000, 'b'));
        }();
        QVERIFY(!status);
        QCOMPARE(status.error().code, base::ErrorCode::OutputFailed);
        QCOMPARE(PipelineCacheFile(m_folder.path().toStdString(), owner()).load(), compiled('a'));
        QCOMPARE(QDir(m_folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    }

    void foldersThatCannotBeMadeAreAnError() {
        const auto taken = std::filesystem::path(m_folder.path().toStdString()) / "taken";
        QVERIFY(model::writeWholeFile(taken, "a file"));
        PipelineCacheFile file(taken, owner());
        QCOMPARE(file.load(), std::string());
        QVERIFY(!file.save(compiled('a')));
    }

    void foldersAreNoFiles() {
        PipelineCacheFile file(m_folder.path().toStdString(), owner());
        std::filesystem::create_directory(file.path());
        QCOMPARE(file.load(), std::string());
        QVERIFY(!file.save(compiled('a')));
    }

    void theFolderIsTheUsersCache() {
        const QByteArray home = qgetenv("HOME");
        const bool hadCache = qEnvironmentVariableIsSet("XDG_CACHE_HOME");
        const QByteArray cache = qgetenv("XDG_CACHE_HOME");
        qputenv("HOME", "/home/somebody");
        qputenv("XDG_CACHE_HOME", "/caches");
        QCOMPARE(pipelineCacheFolder(), std::filesystem::path("/caches/copperscope"));
        qputenv("XDG_CACHE_HOME", "caches");
        QCOMPARE(pipelineCacheFolder(), std::filesystem::path("/home/somebody/.cache/copperscope"));
        qunsetenv("XDG_CACHE_HOME");
        QCOMPARE(pipelineCacheFolder(), std::filesystem::path("/home/somebody/.cache/copperscope"));
        qputenv("HOME", "");
        QCOMPARE(pipelineCacheFolder(), std::filesystem::path());
        qputenv("HOME", home);
        if (hadCache) {
            qputenv("XDG_CACHE_HOME", cache);
        }
    }
};

QTEST_APPLESS_MAIN(PipelineCacheFileTest)
#include "pipeline_cache_file_test.moc"
