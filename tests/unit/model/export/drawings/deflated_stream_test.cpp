#include "model/export/drawings/deflated_stream.h"

#include <QtEndian>
#include <QtTest>
#include <random>

#include "model/base/parallel.h"

namespace {

constexpr std::size_t kPart = 262'144;  // bytes that are compressed together
constexpr std::size_t kGathered = 64 * kPart;

/// Numbers and words, as drawings have them.
std::string textOf(std::size_t length) {
    std::mt19937 random(static_cast<std::uint32_t>(length));
    std::string text;
    while (text.size() < length) {
        text += std::to_string(random() % 100'000U) + (random() % 4U == 0 ? " l\n" : " ");
    }
    text.resize(length);
    return text;
}

std::string deflated(std::string_view text, std::size_t step) {
    std::string packed;
    model::DeflatedStream stream([&](std::string_view bytes) { packed += bytes; });
    for (std::size_t at = 0; at < text.size(); at += step) {
        stream.add(text.substr(at, step));
    }
    stream.end();
    return packed;
}

/// What Qt unpacks, which holds the checksum against it; null where something is wrong.
QByteArray inflated(const std::string& packed, std::size_t length) {
    QByteArray all(4, '\0');
    qToBigEndian<quint32>(static_cast<quint32>(length), all.data());
    return qUncompress(all + QByteArray::fromStdString(packed));
}

}  // namespace

class DeflatedStreamTest : public QObject {
    Q_OBJECT

private slots:
    void unpackedItIsTheText_data() {
        QTest::addColumn<quint64>("length");
        for (const std::size_t length :
             {std::size_t{0}, std::size_t{1}, kPart - 1, kPart, kPart + 1, 3 * kPart, kGathered, kGathered + 5}) {
            QTest::addRow("%zu", length) << quint64{length};
        }
    }
    void unpackedItIsTheText() {
        QFETCH(quint64, length);
        const std::string text = textOf(length);
        const QByteArray back = inflated(deflated(text, 997), text.size());
        QVERIFY(!back.isNull());
        QVERIFY(back == QByteArrayView(text));
    }

    void whatCannotBePackedIsKept() {
        std::mt19937 random(7);
        std::string noise(2 * kPart + 3, '\0');
        std::ranges::generate(noise, [&] { return static_cast<char>(random()); });
        const std::string packed = deflated(noise, kPart);
        QVERIFY(packed.size() < noise.size() + noise.size() / 1000 + 64);
        QVERIFY(inflated(packed, noise.size()) == QByteArrayView(noise));
    }

    void theSameBitsWithAnyNumberOfThreads() {
        const std::string text = textOf(5 * kPart + 11);
        const std::string many = deflated(text, 4096);
        const base::ThreadLimit one(1);
        QVERIFY(deflated(text, 4096) == many);
    }

    void partsCostLittle() {
        const std::string text = textOf(8 * kPart);
        const QByteArray whole = qCompress(QByteArray::fromStdString(text), 5);
        QVERIFY(static_cast<double>(deflated(text, 4096).size()) < 1.01 * static_cast<double>(whole.size()));
    }
};

QTEST_APPLESS_MAIN(DeflatedStreamTest)
#include "deflated_stream_test.moc"
