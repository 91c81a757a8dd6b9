#include "model/formats/common/archive.h"

#include <sys/stat.h>
#include <unistd.h>

#include <clocale>

#include "model/formats/common/archive_stream.h"
#include "model/formats/odb/text/job_tree.h"
#include "model/text/gzip_stream.h"
#include "tests/unit/model/formats/odb/odb_testing.h"
#include "tests/zip.h"

using namespace odb_testing;
using model::Diagnostics;
using model::formats::Archive;
using model::formats::ArchiveLimits;
using model::formats::Bytes;

namespace {

base::Result<Archive> open(const fs::path& path, Diagnostics& diagnostics, const ArchiveLimits& limits = {}) {
    base::Progress progress;
    return Archive::open(path, limits, progress, diagnostics);
}

/// Packed in one member of gzip for each piece.
std::string gzip(const std::vector<std::string>& pieces) {
    std::string packed;
    for (const std::string& piece : pieces) {
        model::GzipStream stream;
        stream.add(piece, packed);
        stream.finish(packed);
    }
    return packed;
}

/// All files with their bytes, or why there are none.
std::string contentsOf(const base::Result<Archive>& archive) {
    if (!archive) {
        return archive.error().text;
    }
    std::string all;
    for (const auto& [name, row] : archive->rows()) {
        const auto bytes = archive->bytes(row);
        all += name + "=" + std::to_string(archive->storedSize(row)) + ":" +
               (bytes ? std::string(bytes->view()) : bytes.error().text) + "\n";
    }
    return all;
}

/// Names that must not exist after an archive was read, whatever it holds.
bool nothingWasWritten(const Folder& folder, std::size_t filesBefore) {
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : fs::recursive_directory_iterator(folder.path())) {
        ++files;
    }
    return files == filesBefore;
}

void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

void addEntry(archive* out, const char* name, unsigned kind, const char* hardLinkTo) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, name);
    archive_entry_set_filetype(entry, kind);
    archive_entry_set_perm(entry, 0644);
    if (kind == AE_IFLNK) {
        archive_entry_set_symlink(entry, "/etc/passwd");
    }
    if (hardLinkTo != nullptr) {
        archive_entry_set_hardlink(entry, hardLinkTo);
    }
    archive_write_header(out, entry);
    archive_entry_free(entry);
}

/// job/plain, and job/special of this kind.
void writeSpecial(const fs::path& path, unsigned kind, bool isHardLink) {
    archive* out = archive_write_new();
    archive_write_set_format_ustar(out);
    if (archive_write_open_filename(out, path.c_str()) != ARCHIVE_OK) {
        qFatal("cannot write %s", path.c_str());
    }
    addEntry(out, "job/plain", AE_IFREG, nullptr);
    addEntry(out, "job/special", kind, isHardLink ? "job/plain" : nullptr);
    archive_write_close(out);
    archive_write_free(out);
}

/// While it lives, permissions hold for who runs the tests, root included.
class Unprivileged {
public:
    Unprivileged() : m_isIn(::geteuid() != 0 || ::seteuid(65'534) == 0) {}
    ~Unprivileged() {
        if (::getuid() == 0 && ::seteuid(0) != 0) {
            qFatal("cannot be root again");
        }
    }
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;
    [[nodiscard]] bool isIn() const { return m_isIn; }

private:
    bool m_isIn;
};

/// What is said of a file or folder of a tree.
std::string saidOf(const Diagnostics& diagnostics, std::string_view file) {
    std::string all;
    for (const model::Diagnostic& entry : diagnostics.entries()) {
        if (entry.file == file) {
            all += std::string(model::toString(entry.severity)) + ": " + entry.text;
        }
    }
    return all;
}

}  // namespace

class ArchiveTest : public QObject {
    Q_OBJECT

private slots:
    void everyContainerGivesTheSameDocument_data() {
        QTest::addColumn<int>("container");
        QTest::addColumn<int>("packing");
        QTest::addColumn<QString>("prefix");
        QTest::addColumn<unsigned>("mode");
        const auto row = [](const char* name, Container c, Packing p, const char* prefix, unsigned mode) {
            QTest::newRow(name) << static_cast<int>(c) << static_cast<int>(p) << prefix << mode;
        };
        row("tgz with a top folder", Container::Ustar, Packing::Gzip, "job/", 0644);
        row("tgz without a top folder", Container::Ustar, Packing::Gzip, "", 0644);
        row("plain tar", Container::Ustar, Packing::Plain, "odb/", 0644);
        row("old V7 tar", Container::V7Tar, Packing::Gzip, "", 0644);
        row("tar.Z", Container::Ustar, Packing::Compress, "job/", 0644);
        row("entries of mode 000", Container::Ustar, Packing::Gzip, "odbjob/", 0000);
        row("zip", Container::Zip, Packing::Plain, "a/b/job/", 0644);
        row("leading ./", Container::Ustar, Packing::Gzip, "./job/", 0644);
    }
    void everyContainerGivesTheSameDocument() {
        QFETCH(int, container);
        QFETCH(int, packing);
        QFETCH(QString, prefix);
        QFETCH(unsigned, mode);
        Folder folder;
        const fs::path path = folder.path() / "board.archive";
        writeArchive(path, static_cast<Container>(container), static_cast<Packing>(packing),
                     membersOf(dataJob("everything"), prefix.toStdString(), mode));
        QVERIFY(fingerprint(*read(path)) == fingerprint(*read(dataJob("everything"))));
    }

    void entriesThatClimbOrAreAbsoluteAreLeftOut() {
        Folder folder;
        const fs::path path = folder.path() / "hostile.tgz";
        std::vector<Member> members = membersOf(dataJob("everything"), "job/");
        members.push_back({"../climbed", "x", 0644, {}});
        members.push_back({"job/steps/../../../climbed", "x", 0644, {}});
        members.push_back({"/tmp/absolute", "x", 0644, {}});
        members.push_back({"C:\\windows", "x", 0644, {}});
        members.push_back({"job/link", "", 0644, "/etc/passwd"});
        members.push_back({"job/..hidden/fine", "x", 0644, {}});
        writeArchive(path, Container::Ustar, Packing::Gzip, members);
        Diagnostics diagnostics;
        const auto archive = open(path, diagnostics);
        QVERIFY(archive.ok());
        QCOMPARE(diagnostics.count(model::Severity::Error), 5U);
        QVERIFY(findDiagnostic(diagnostics, "'..'") != nullptr);
        QVERIFY(findDiagnostic(diagnostics, "absolute") != nullptr);
        QVERIFY(findDiagnostic(diagnostics, "link") != nullptr);
        QCOMPARE(archive->find("../climbed"), -1);
        QCOMPARE(archive->find("job/link"), -1);
        QVERIFY(archive->find("job/..hidden/fine") >= 0);
        QVERIFY(nothingWasWritten(folder, 1));
        QCOMPARE(read(path)->nets.size(), std::size_t{3});
    }

    void linksAndDevicesAreLeftOut_data() {
        QTest::addColumn<unsigned>("kind");
        QTest::addColumn<bool>("isHardLink");
        QTest::newRow("symbolic link") << unsigned{AE_IFLNK} << false;
        QTest::newRow("hard link") << unsigned{AE_IFREG} << true;
        QTest::newRow("named pipe") << unsigned{AE_IFIFO} << false;
        QTest::newRow("character device") << unsigned{AE_IFCHR} << false;
        QTest::newRow("block device") << unsigned{AE_IFBLK} << false;
    }
    void linksAndDevicesAreLeftOut() {
        QFETCH(unsigned, kind);
        QFETCH(bool, isHardLink);
        Folder folder;
        const fs::path path = folder.path() / "hostile.tar";
        writeSpecial(path, kind, isHardLink);
        Diagnostics diagnostics;
        const auto archive = open(path, diagnostics);
        QVERIFY(archive.ok());
        QCOMPARE(archive->find("job/special"), -1);
        QVERIFY(archive->find("job/plain") >= 0);
        QVERIFY(findDiagnostic(diagnostics, "a link or a device") != nullptr);
        QVERIFY(nothingWasWritten(folder, 1));
    }

    void noProgramIsRunToUnpack_data() {
        QTest::addColumn<QByteArray>("magic");
        QTest::newRow("lrzip") << QByteArray("LRZI\0\6", 6);
        QTest::newRow("grzip") << QByteArray("GRZipII\0\2\4:)", 12);
        QTest::newRow("lzop") << QByteArray("\x89LZO\0\r\n\x1a\n", 9);
    }
    void noProgramIsRunToUnpack() {
        QFETCH(QByteArray, magic);
        Folder folder;
        const fs::path ran = folder.path() / "ran";
        const fs::path program = folder.path() / QTest::currentDataTag();
        write(program, "#!/bin/sh\n: > '" + ran.string() + "'\n");
        fs::permissions(program, fs::perms::owner_all);
        const fs::path board = folder.path() / "board.tgz";
        write(board, magic.toStdString() + std::string(4096, 'x'));
        const QByteArray path = qgetenv("PATH");
        qputenv("PATH", QByteArray::fromStdString(folder.path().string()) + ":" + path);
        Diagnostics diagnostics;
        const bool isOpen = open(board, diagnostics).ok();
        qputenv("PATH", path);
        QVERIFY(!isOpen);
        QVERIFY(!fs::exists(ran));
    }

    /// One whole member is unpacked at one go (gzip_member.h), everything else by libarchive: nobody can tell.
    void membersOfGzipMakeNoDifference_data() {
        QTest::addColumn<int>("container");
        QTest::newRow("ustar") << static_cast<int>(Container::Ustar);
        QTest::newRow("V7") << static_cast<int>(Container::V7Tar);
    }
    void membersOfGzipMakeNoDifference() {
        QFETCH(int, container);
        Folder folder;
        std::vector<Member> members = membersOf(dataJob("everything"), "job/");
        writeArchive(folder.path() / "inner.zip", Container::Zip, Packing::Plain, {{"a", "a file", 0644, {}}});
        members.push_back({"job/empty", "", 0644, {}});
        members.push_back({"job/last.zip", readFile(folder.path() / "inner.zip"), 0644, {}});
        writeArchive(folder.path() / "plain", static_cast<Container>(container), Packing::Plain, members);
        const std::string tar = readFile(folder.path() / "plain");
        Diagnostics diagnostics;
        const std::size_t half = tar.size() / 2;
        const std::string twoMembers = gzip({tar.substr(0, half), tar.substr(half)});
        const std::string expected = contentsOf(open(folder.write("packed.tgz", twoMembers), diagnostics));
        QVERIFY(expected.find("job/matrix/matrix=") != std::string::npos);
        QVERIFY(expected.find("job/last.zip=") != std::string::npos);
        for (const std::string& packed : {gzip({tar}), twoMembers, gzip({tar}) + "behind it", gzip({gzip({tar})})}) {
            const fs::path path = folder.write("packed.tgz", packed);
            QVERIFY(contentsOf(open(path, diagnostics)) == expected);
            base::Progress progress;
            auto unpacked = Archive::unpack(packed, path, {}, progress, diagnostics);
            QVERIFY(unpacked.ok());
            const base::Result<Archive> moved = std::move(*unpacked);
            QVERIFY(contentsOf(moved) == expected);
        }
        QCOMPARE(diagnostics.count(model::Severity::Error), 0U);
    }

    void textInGzipIsALoneFile() {
        Folder folder;
        const std::string text(100'000, 'x');
        for (const std::string& packed : {gzip({text}), gzip({text, ""}), gzip({text}) + "behind it"}) {
            Diagnostics diagnostics;
            const auto archive = open(folder.write("board.xml.gz", packed), diagnostics);
            QVERIFY(archive.ok());
            QCOMPARE(archive->size(), std::size_t{1});
            QCOMPARE(archive->path(0), std::string("board.xml"));
            QVERIFY(archive->bytes(0)->view() == text);
        }
    }

    void archivesThatEndInGzipAreAClearError() {
        Folder folder;
        writeArchive(folder.path() / "plain", Container::Ustar, Packing::Plain,
                     membersOf(dataJob("everything"), "job/"));
        const std::string cut = readFile(folder.path() / "plain").substr(0, 5000);
        Diagnostics diagnostics;
        const std::string oneMember = contentsOf(open(folder.write("part.tgz", gzip({cut})), diagnostics));
        const std::string twoMembers = contentsOf(open(folder.write("part.tgz", gzip({cut, ""})), diagnostics));
        QVERIFY2(oneMember.find("ends early") != std::string::npos, oneMember.c_str());
        QCOMPARE(oneMember, twoMembers);
    }

    void everyTruncatedArchiveIsAClearError() {
        Folder folder;
        const fs::path whole = folder.path() / "whole.tgz";
        writeArchive(whole, Container::Ustar, Packing::Gzip, membersOf(dataJob("everything"), "job/"));
        const std::string bytes = readFile(whole);
        for (std::size_t length = 1; length + 16 < bytes.size(); length += 97) {
            const auto result = tryRead(folder.write("part.tgz", bytes.substr(0, length)));
            QVERIFY(!result.ok());
            QCOMPARE(result.error().code, base::ErrorCode::BadInput);
            QVERIFY(result.error().text.find("part.tgz") != std::string::npos);
        }
    }

    void aPackedFileThatEndsEarlyIsCalledThat() {
        Folder folder;
        std::string noise;
        for (unsigned i = 0, state = 1; i < 100'000; ++i) {
            state = state * 1'664'525U + 1'013'904'223U;
            noise += static_cast<char>('a' + (state >> 24U) % 26U);
        }
        const std::string bytes = gzip({"<?xml version=\"1.0\"?>" + noise});
        for (const std::string& part : {bytes.substr(0, 50), bytes.substr(0, bytes.size() / 2)}) {
            const auto result = tryRead(folder.write("board.xml.gz", part));
            QVERIFY(!result.ok());
            QVERIFY2(result.error().text.find("is packed, but ends early or is damaged") != std::string::npos,
                     result.error().text.c_str());
        }
    }

    void everyTruncatedZipIsAnErrorOrReadsWhatIsLeft() {
        Folder folder;
        const fs::path whole = folder.path() / "whole.zip";
        writeArchive(whole, Container::Zip, Packing::Plain, membersOf(dataJob("everything"), "job/"));
        const std::string bytes = readFile(whole);
        for (std::size_t length = 1; length < bytes.size(); length += 211) {
            const auto result = tryRead(folder.write("part.zip", bytes.substr(0, length)));
            QVERIFY(result.ok() || result.error().code == base::ErrorCode::BadInput);
        }
    }

    void missingEmptyAndForeignFilesAreClearErrors() {
        Folder folder;
        const auto textOf = [](const fs::path& path) {
            const auto result = tryRead(path);
            return result.ok() ? std::string() : result.error().text;
        };
        QVERIFY(textOf(folder.path() / "absent.tgz").find("no such file") != std::string::npos);
        QVERIFY(textOf(folder.write("empty.tgz", "")).find("an empty file") != std::string::npos);
        QVERIFY(textOf(folder.write("text.tgz", "this is no archive at all")).find("a text file") != std::string::npos);
        QVERIFY(textOf(folder.write("folder/readme", "hello")).find("a text file") != std::string::npos);
        QVERIFY(textOf(folder.path() / "folder").find("a folder without an ODB++ matrix") != std::string::npos);
        writeArchive(folder.path() / "other.tgz", Container::Ustar, Packing::Gzip, {{"readme", "hello", 0644, {}}});
        QVERIFY(textOf(folder.path() / "other.tgz").find("a gzip archive without an ODB++ matrix") !=
                std::string::npos);
        writeArchive(folder.path() / "none.tgz", Container::Ustar, Packing::Gzip, {});
        QVERIFY(!textOf(folder.path() / "none.tgz").empty());
    }

    void anArchiveThatUnpacksToTooMuchIsRefused_data() {
        QTest::addColumn<int>("container");
        QTest::addColumn<int>("packing");
        QTest::newRow("tar.gz") << static_cast<int>(Container::Ustar) << static_cast<int>(Packing::Gzip);
        QTest::newRow("tar.Z") << static_cast<int>(Container::Ustar) << static_cast<int>(Packing::Compress);
        QTest::newRow("zip") << static_cast<int>(Container::Zip) << static_cast<int>(Packing::Plain);
    }
    void anArchiveThatUnpacksToTooMuchIsRefused() {
        QFETCH(int, container);
        QFETCH(int, packing);
        Folder folder;
        const fs::path path = folder.path() / "bomb";
        writeArchive(path, static_cast<Container>(container), static_cast<Packing>(packing),
                     {{"job/big", std::string(3'000'000, '0'), 0644, {}}});
        QVERIFY(fs::file_size(path) < 100'000);
        Diagnostics diagnostics;
        ArchiveLimits limits;
        limits.totalBytes = 2'000'000;
        const auto large = open(path, diagnostics, limits);
        QVERIFY(!large.ok());
        QVERIFY(large.error().text.find("too much") != std::string::npos);
        limits.totalBytes = 4'000'000;
        QVERIFY(open(path, diagnostics, limits).ok());
        limits.entries = 0;
        QVERIFY(open(path, diagnostics, limits).error().text.find("more than 0, the limit") != std::string::npos);
    }

    void namesAreFoundWhateverTheirCase() {
        Folder folder;
        folder.write("steps/pcb/layers/Assembly Text Top/Features", "x");
        folder.write("steps/pcb/layers/ASSEMBLY TEXT TOP/features", "y");
        Diagnostics diagnostics;
        const auto archive = open(folder.path(), diagnostics);
        QVERIFY(archive.ok());
        QVERIFY(archive->find("STEPS/PCB/LAYERS/assembly text TOP/FEATURES") >= 0);
        QCOMPARE(diagnostics.count(model::Severity::Warning), 1U);
    }

    /// Commands run in the locale "C", which has no such letters.
    void namesBeyondAsciiAreRead() {
        std::setlocale(LC_ALL, "C");
        Folder folder;
        const std::string utf8 = "grün.gbl";
        const std::string codePage437 = "gr\x81n.gbl";
        const std::string none = "gr\xFCn.gbl";  // of Latin-1
        const fs::path path = folder.write(
            "board.zip", zip::packed({{utf8, "a", zip::kUtf8Name}, {codePage437, "b"}, {none, "c", zip::kUtf8Name}}));
        Diagnostics diagnostics;
        const auto archive = open(path, diagnostics);
        QVERIFY(archive.ok());
        QVERIFY(archive->find(utf8) >= 0);
        QVERIFY(archive->find(codePage437) >= 0);
        QCOMPARE(archive->size(), std::size_t{2});
        QCOMPARE(diagnostics.count(model::Severity::Error), 1U);
        QVERIFY(findDiagnostic(diagnostics, "has no name that can be read") != nullptr);
    }

    void linksInFoldersAreFollowed() {
        Folder folder;
        const fs::path job = folder.path() / "job";
        folder.write("job/board.gtl", "top");
        folder.write("job/inner/board.drl", "drills");
        folder.write("elsewhere/board.gbl", "bottom");
        for (const auto& [name, target] : std::vector<std::pair<std::string, std::string>>{{"bottom", "../elsewhere"},
                                                                                           {"alias", "inner"},
                                                                                           {"here", "."},
                                                                                           {"up", ".."},
                                                                                           {"gone.gko", "../missing"},
                                                                                           {"own.gbo", "own.gbo"},
                                                                                           {".#board", "who@host"}}) {
            fs::create_symlink(target, job / name);
        }
        QCOMPARE(mkfifo((job / "pipe.gto").c_str(), 0600), 0);
        Diagnostics diagnostics;
        const auto archive = open(job, diagnostics);
        QCOMPARE(contentsOf(archive), "board.gtl=3:top\nbottom/board.gbl=6:bottom\ninner/board.drl=6:drills\n");
        QCOMPARE(saidOf(diagnostics, "alias"), "info: The folder is read by another name, and once only");
        QCOMPARE(saidOf(diagnostics, "here"), "info: The folder is read by another name, and once only");
        QCOMPARE(saidOf(diagnostics, "up"), "warning: The link leads to a folder that holds this one and was left out");
        QCOMPARE(saidOf(diagnostics, "gone.gko"), "error: The link leads to nothing");
        QVERIFY(saidOf(diagnostics, "own.gbo").starts_with("error: It cannot be read: "));
        QCOMPARE(saidOf(diagnostics, ".#board"), "info: The link leads to nothing");
        QCOMPARE(saidOf(diagnostics, "pipe.gto"), "error: It is a pipe or a device and was left out");
        QCOMPARE(diagnostics.entries().size(), std::size_t{7});
    }

    void foldersThatMayNotBeReadAreSaid() {
        Folder folder;
        const fs::path job = folder.path() / "job";
        folder.write("job/board.gtl", "top");
        folder.write("job/bottom/board.gbl", "bottom");
        for (const fs::path& seen : {folder.path(), job}) {
            fs::permissions(seen, fs::perms{0755});
        }
        fs::permissions(job / "board.gtl", fs::perms{0644});
        fs::permissions(job / "bottom", fs::perms::none);
        const auto giveBack = qScopeGuard([&] { fs::permissions(job / "bottom", fs::perms::owner_all); });
        const Unprivileged unprivileged;
        if (!unprivileged.isIn()) {
            QSKIP("permissions do not hold for root");
        }
        std::error_code error;
        const fs::directory_iterator listed(job, error);
        if (error) {
            QSKIP("temporary folders are for root alone");
        }
        Diagnostics diagnostics;
        QCOMPARE(contentsOf(open(job, diagnostics)), "board.gtl=3:top\n");
        QCOMPARE(saidOf(diagnostics, "bottom"), "error: The folder cannot be read: Permission denied");
        QCOMPARE(tryRead(job / "bottom").error().text,
                 (job / "bottom").string() + ": the folder cannot be read: Permission denied");
        QCOMPARE(tryRead(job / "bottom" / "board.gbl").error().text,
                 (job / "bottom" / "board.gbl").string() + ": it cannot be read: Permission denied");
    }

    void packedMembersAreToldByTheirFirstBytes_data() {
        QTest::addColumn<int>("container");
        QTest::addColumn<int>("packing");
        QTest::newRow("Unix compress") << static_cast<int>(Container::Raw) << static_cast<int>(Packing::Compress);
        QTest::newRow("gzip") << static_cast<int>(Container::Raw) << static_cast<int>(Packing::Gzip);
        QTest::newRow("zip") << static_cast<int>(Container::Zip) << static_cast<int>(Packing::Plain);
        QTest::newRow("plain") << static_cast<int>(Container::Raw) << static_cast<int>(Packing::Plain);
    }
    void packedMembersAreToldByTheirFirstBytes() {
        QFETCH(int, container);
        QFETCH(int, packing);
        Folder folder;
        folder.copyJob("everything");
        const fs::path plain = folder.path() / "steps/board/layers/top/features";
        writeArchive(folder.path() / "packed", static_cast<Container>(container), static_cast<Packing>(packing),
                     {{"features", readFile(plain), 0644, {}}});
        const std::string packed = readFile(folder.path() / "packed");
        fs::remove(plain);
        folder.write("steps/board/layers/top/features.Z", packed);
        const auto document = read(folder.path());
        QCOMPARE(document->layer(document->findLayer("top")).featureCount, 27U);
        QCOMPARE(document->layer(document->findLayer("top")).file, std::string("steps/board/layers/top/features.Z"));
    }

    void aBrokenPackedMemberIsReportedAndTheRestIsRead() {
        Folder folder;
        folder.copyJob("everything");
        fs::remove(folder.path() / "steps/board/layers/top/features");
        for (const char* bytes : {"\x1f\x9d\x90\xff\xff\xff\xff\xff", "\x1f\x8b\x08zzz", "PK\x03\x04zzzzzz"}) {
            folder.write("steps/board/layers/top/features.Z", bytes);
            const auto document = read(folder.path());
            const model::Diagnostic* entry = findDiagnostic(document->diagnostics, "packed file is broken");
            QVERIFY(entry != nullptr);
            QCOMPARE(entry->file, std::string("steps/board/layers/top/features.Z"));
            QCOMPARE(document->layer(document->findLayer("bottom")).elements.count, 1U);
        }
    }

    void aPackedMemberMayNotGrowBeyondItsLimit_data() {
        QTest::addColumn<int>("container");
        QTest::addColumn<int>("packing");
        QTest::newRow("Unix compress") << static_cast<int>(Container::Raw) << static_cast<int>(Packing::Compress);
        QTest::newRow("gzip") << static_cast<int>(Container::Raw) << static_cast<int>(Packing::Gzip);
        QTest::newRow("zip") << static_cast<int>(Container::Zip) << static_cast<int>(Packing::Plain);
    }
    void aPackedMemberMayNotGrowBeyondItsLimit() {
        QFETCH(int, container);
        QFETCH(int, packing);
        Folder folder;
        writeArchive(folder.path() / "packed", static_cast<Container>(container), static_cast<Packing>(packing),
                     {{"m", std::string(100'000, 'x'), 0644, {}}});
        const std::string packed = readFile(folder.path() / "packed");
        const auto large = model::formats::decodeMember(Bytes(packed), 99'999);
        QVERIFY(!large.ok());
        QVERIFY(large.error().text.find("more than 99999 bytes, the limit for one file") != std::string::npos);
        QCOMPARE(model::formats::decodeMember(Bytes(packed), 100'000)->view().size(), std::size_t{100'000});
    }

    void theShallowestJobOfAnArchiveIsTaken() {
        Folder folder;
        folder.write("job/matrix/matrix", "x");
        folder.write("job/steps/a/stephdr", "x");
        folder.write("job/user/copy/matrix/matrix", "x");
        folder.write("job/user/copy/steps/b/stephdr", "x");
        folder.write("matrix/matrix", "no steps beside it");
        Diagnostics diagnostics;
        const auto archive = open(folder.path(), diagnostics);
        const auto tree = model::odb::findJob(*archive);
        QVERIFY(tree.ok());
        QCOMPARE(tree->name(), std::string("job"));
        QCOMPARE(tree->foldersIn("steps"), std::vector<std::string>{"a"});
        QVERIFY(tree->has("STEPS/A/stephdr"));
        QVERIFY(!tree->has("user/copy/steps/c"));
    }

    void cancellingStopsTheReading() {
        base::Progress progress;
        progress.cancel();
        const auto result = model::readBoard(dataJob("everything"), {}, progress);
        QVERIFY(!result.ok());
        QCOMPARE(result.error().code, base::ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(ArchiveTest)
#include "archive_test.moc"
