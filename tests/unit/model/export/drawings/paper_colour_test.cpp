#include "model/export/drawings/paper_colour.h"

#include <QtTest>
#include <cmath>

using model::onPaper;

namespace {

double luminance(std::uint32_t colour) {
    double sum = 0.0;
    for (const auto& [shift, weight] : {std::pair(16U, 0.2126), std::pair(8U, 0.7152), std::pair(0U, 0.0722)}) {
        const double part = static_cast<double>(colour >> shift & 0xFFU) / 255.0;
        sum += weight * (part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
    }
    return sum;
}

}  // namespace

class PaperColourTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsSeenStays() {
        for (const std::uint32_t colour : {0x000000U, 0xFF0000U, 0x0000FFU, 0x804000U, 0x006000U}) {
            QCOMPARE(onPaper(colour), colour);
        }
    }

    void whatIsPaleGetsDarkerAndKeepsItsHue() {
        for (const std::uint32_t colour : {0xFFFFFFU, 0xF2EDA1U, 0xFFFF00U, 0x00FFFFU, 0xC0C0C0U}) {
            const std::uint32_t darker = onPaper(colour);
            QVERIFY(1.05 / (luminance(darker) + 0.05) >= 3.0);
            QVERIFY(1.05 / (luminance(darker) + 0.05) < 3.1);
        }
        QCOMPARE(onPaper(0xFFFFFFU) & 0xFFU, onPaper(0xFFFFFFU) >> 16U);
        QCOMPARE(onPaper(0xFFFF00U) & 0xFFU, 0U);
        QCOMPARE(onPaper(0x00FFFFU) >> 16U, 0U);
    }
};

QTEST_APPLESS_MAIN(PaperColourTest)
#include "paper_colour_test.moc"
