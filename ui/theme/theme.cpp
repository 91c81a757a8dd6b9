#include "ui/theme/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyle>
#include <QStyleFactory>
#include <QStyleOption>

namespace ui {

namespace {

struct Tone {
    QPalette::ColorRole role;
    QRgb dark;
    QRgb light;
};

constexpr Tone kTones[] = {
    {QPalette::Window, 0xff2b2d31, 0xfff2f2f3},
    {QPalette::WindowText, 0xffdfe1e5, 0xff1d1e21},
    {QPalette::Base, 0xff1f2124, 0xffffffff},
    {QPalette::AlternateBase, 0xff26282c, 0xfff6f7f8},
    {QPalette::Text, 0xffdfe1e5, 0xff1d1e21},
    {QPalette::PlaceholderText, 0xff8b9098, 0xff7a7f87},
    {QPalette::Button, 0xff34373c, 0xffe9eaec},
    {QPalette::ButtonText, 0xffdfe1e5, 0xff1d1e21},
    {QPalette::BrightText, 0xffffffff, 0xff000000},
    {QPalette::ToolTipBase, 0xff3a3e44, 0xfffffbe6},
    {QPalette::ToolTipText, 0xffe8eaed, 0xff1d1e21},
    {QPalette::Highlight, 0xffa65a24, 0xffa65a24},
    {QPalette::HighlightedText, 0xffffffff, 0xffffffff},
    {QPalette::Link, 0xfff0a060, 0xff9a4b10},
    {QPalette::Light, 0xff44484e, 0xffffffff},
    {QPalette::Midlight, 0xff3c4046, 0xfff6f6f7},
    {QPalette::Mid, 0xff212327, 0xffc0c3c8},
    {QPalette::Dark, 0xff1a1b1e, 0xffa2a6ad},
    {QPalette::Shadow, 0xff0c0d0f, 0xff6f737a},
};

constexpr QPalette::ColorRole kTextRoles[] = {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                              QPalette::HighlightedText};

/// Fusion, whose empty check boxes, grooves of sliders and mark of a toolbar that has no room for all of its buttons
/// vanish on a dark ground, with these in the colour of the text.
class FramedBoxes : public QProxyStyle {
public:
    FramedBoxes() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element == PE_IndicatorCheckBox) {
            frame(option->rect, *option, *painter,
                  isInSelectedRow(*option) ? QPalette::HighlightedText : QPalette::Text);
        }
    }

    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        // Qt's own name for the button, whose picture is black.
        if (element == CE_ToolButtonLabel && widget != nullptr &&
            widget->objectName() == QLatin1String("qt_toolbar_ext_button")) {
            painter->setPen(option->palette.color(QPalette::ButtonText));
            painter->drawText(option->rect, Qt::AlignCenter, QStringLiteral("»"));
            return;
        }
        QProxyStyle::drawControl(element, option, painter, widget);
    }

    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override {
        const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
        if (control != CC_Slider || slider == nullptr) {
            QProxyStyle::drawComplexControl(control, option, painter, widget);
            return;
        }
        // The handle lies on the frame of its groove.
        QStyleOptionSlider part = *slider;
        part.subControls = slider->subControls & ~SC_SliderHandle;
        QProxyStyle::drawComplexControl(control, &part, painter, widget);
        if (slider->subControls.testFlag(SC_SliderGroove)) {
            // Fusion leaves a pixel around it.
            frame(subControlRect(control, slider, SC_SliderGroove, widget).adjusted(1, 1, -1, -1), *option, *painter,
                  QPalette::Text);
        }
        part.subControls = slider->subControls & SC_SliderHandle;
        QProxyStyle::drawComplexControl(control, &part, painter, widget);
    }

private:
    static bool isInSelectedRow(const QStyleOption& option) {
        return qstyleoption_cast<const QStyleOptionViewItem*>(&option) != nullptr &&
               option.state.testFlag(State_Selected);
    }

    /// On the strong colour of a selected row a faint one would not be seen.
    static void frame(const QRect& rect, const QStyleOption& option, QPainter& painter, QPalette::ColorRole ink) {
        QColor tone = option.palette.color(ink);
        tone.setAlpha(ink == QPalette::HighlightedText ? 235 : 110);
        painter.save();
        painter.setPen(tone);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect.adjusted(0, 0, -1, -1));
        painter.restore();
    }
};

QPalette ownPalette(bool isDark) {
    QPalette palette;
    for (const Tone& tone : kTones) {
        palette.setColor(tone.role, QColor::fromRgb(isDark ? tone.dark : tone.light));
    }
    for (const QPalette::ColorRole role : kTextRoles) {
        palette.setColor(QPalette::Disabled, role, QColor::fromRgb(isDark ? 0xff777c84 : 0xff9a9fa6));
    }
    return palette;
}

/// The desktop's own style by name, asked for before it is ever changed.
QString systemStyle() {
    static const QString name = QApplication::style()->name();
    return name;
}

}  // namespace

void applyTheme(Theme theme) {
    const QString desktop = systemStyle();
    if (theme == Theme::System) {
        QApplication::setStyle(desktop);
        QApplication::setPalette(QPalette());
        return;
    }
    // Native styles ignore palettes in places; Fusion follows them everywhere.
    QApplication::setStyle(new FramedBoxes);
    QApplication::setPalette(ownPalette(theme == Theme::Dark));
}

}  // namespace ui
