#pragma once

#include "ui/parts/parts_panel.h"
#include "ui/parts/pins_panel.h"
#include "ui/workspace/feature.h"

namespace ui {

/// Components and their pins: a panel each.
class PartsFeature : public QObject {
    Q_OBJECT

public:
    explicit PartsFeature(FeatureContext& context);

private:
    void connectFollowing(const FeatureContext& context);
    void connectExports(const FeatureContext& context);

    PartModel m_parts;
    PinModel m_pins;
    PartsPanel* m_partsPanel;
    PinsPanel* m_pinsPanel;
};

}  // namespace ui
