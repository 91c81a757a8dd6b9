#include "model/formats/common/gzip_member.h"

#include <QtTest>
#include <random>

#include "model/text/gzip_stream.h"

using model::formats::FileBytes;
using model::formats::kGzipMagic;
using model::formats::unpackGzip;

class GzipMemberTest : public QObject {
    Q_OBJECT

    static constexpr std::uint64_t kNoLimit = ~std::uint64_t{0};

    static std::string pack(const std::string& text) {
        std::string packed;
        model::GzipStream stream;
        stream.add(text, packed);
        stream.finish(packed);
        return packed;
    }
    static std::string text(std::size_t size) {
        std::minstd_rand random(7);
        std::string text(size, ' ');
        for (char& c : text) {
            c = static_cast<char>('0' + random() % 12);
        }
        return text;
    }
    static bool isNothing(const std::string& packed, std::uint64_t limit = kNoLimit) {
        return !unpackGzip(packed, limit).has_value();
    }

private slots:
    void wholeMembersAreUnpacked() {
        for (const std::size_t size : {0U, 1U, 100U, 300'000U, 9'000'000U}) {
            const auto unpacked = unpackGzip(pack(text(size)), kNoLimit);
            QVERIFY(unpacked.has_value());
            QVERIFY(unpacked->view() == text(size));
        }
    }

    void bytesStayWhereTheyAreWhenMoved() {
        auto unpacked = unpackGzip(pack(text(5'000'000)), kNoLimit);
        QVERIFY(unpacked.has_value());
        const char* where = unpacked->view().data();
        const FileBytes moved = *std::move(unpacked);
        QVERIFY(moved.view().data() == where);
        QVERIFY(moved.view() == text(5'000'000));
    }

    void everythingElseIsLeftToLibarchive() {
        const std::string packed = pack(text(3000));
        QVERIFY(isNothing(""));
        QVERIFY(isNothing(std::string(kGzipMagic)));
        QVERIFY(isNothing(text(100)));
        QVERIFY(isNothing(packed + packed));
        QVERIFY(isNothing(packed + "x"));
        QVERIFY(isNothing(packed + std::string(512, '\0')));
        for (std::size_t length = 0; length < packed.size(); ++length) {
            QVERIFY(isNothing(packed.substr(0, length)));
        }
    }

    void whatIsChangedIsNothingOrTheSame() {
        const std::string packed = pack(text(3000));
        std::size_t same = 0;  // the time in the header, the system it names, bits that fill the last byte
        for (std::size_t i = 0; i < packed.size(); ++i) {
            std::string changed = packed;
            changed[i] = static_cast<char>(changed[i] ^ 0x10);
            const auto unpacked = unpackGzip(changed, kNoLimit);
            same += unpacked && unpacked->view() == text(3000) ? 1 : 0;
            QVERIFY(!unpacked || unpacked->view() == text(3000));
        }
        QVERIFY(same <= 8);
    }

    void limitsHold() {
        const std::string packed = pack(text(3000));
        QVERIFY(isNothing(packed, 2999));
        QVERIFY(!isNothing(packed, 3000));
    }

    void sizesThatNobodyCanPackAreNotBelieved() {
        std::string packed = pack(text(3000));
        packed.replace(packed.size() - 4, 4, "\xff\xff\xff\x0f");  // 268 MB, of which all would have to be reserved
        QVERIFY(isNothing(packed));
    }
};

QTEST_APPLESS_MAIN(GzipMemberTest)
#include "gzip_member_test.moc"
