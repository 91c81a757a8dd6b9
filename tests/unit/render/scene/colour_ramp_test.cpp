// Colours of numbers can be told apart and put in order, with and without colour vision.
#include "render/scene/colour_ramp.h"

#include <QtTest>
#include <cmath>

namespace {

float linear(float channel) {
    return channel <= 0.04045F ? channel / 12.92F : std::pow((channel + 0.055F) / 1.055F, 2.4F);
}

float luminance(const glm::vec3& c) {
    return 0.2126F * linear(c.r) + 0.7152F * linear(c.g) + 0.0722F * linear(c.b);
}

}  // namespace

class ColourRampTest : public QObject {
    Q_OBJECT

private slots:
    void everyStepIsDarker() {
        float last = 2.0F;
        for (int i = 0; i <= 64; ++i) {
            const glm::vec3 colour = render::rampColour(static_cast<float>(i) / 64.0F);
            QVERIFY(glm::all(glm::greaterThanEqual(colour, glm::vec3(0.0F))));
            QVERIFY(glm::all(glm::lessThanEqual(colour, glm::vec3(1.0F))));
            QVERIFY2(luminance(colour) < last, qPrintable(QString::number(i)));
            last = luminance(colour);
        }
        QVERIFY(luminance(render::rampColour(0.0F)) > 0.6F);
        QVERIFY(last < 0.1F);
    }

    void numbersBeyondTheEndsAreTheEnds() {
        QVERIFY(render::rampColour(-1.0F) == render::rampColour(0.0F));
        QVERIFY(render::rampColour(7.0F) == render::rampColour(1.0F));
    }
};

QTEST_GUILESS_MAIN(ColourRampTest)
#include "colour_ramp_test.moc"
