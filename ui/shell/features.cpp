#include "ui/shell/features.h"

#include "ui/assignment/assignment_feature.h"
#include "ui/clearance/clearance_feature.h"
#include "ui/comparison/comparison_feature.h"
#include "ui/element/element_feature.h"
#include "ui/export/export_feature.h"
#include "ui/layers/layers_feature.h"
#include "ui/measure/measure_feature.h"
#include "ui/messages/message_model.h"
#include "ui/messages/messages_feature.h"
#include "ui/netlist_check/netlist_check_feature.h"
#include "ui/nets/nets_feature.h"
#include "ui/parts/parts_feature.h"
#include "ui/saved_views/saved_views_feature.h"
#include "ui/search/search_feature.h"
#include "ui/section/section_feature.h"
#include "ui/stackup/stackup_feature.h"
#include "ui/statistics/statistics_feature.h"
#include "ui/views/views_feature.h"

namespace ui {

namespace {

template <class Feature>
void add(FeatureContext& context) {
    new Feature(context);
}

/// Panels lie behind each other, and painters over each other, in this order.
constexpr void (*kFeatures[])(FeatureContext&) = {
    addViews,
    addLayers,
    addStackup,
    add<NetsFeature>,
    addElement,
    add<SavedViewsFeature>,
    addMessages,
    add<NetlistCheckFeature>,
    add<ComparisonFeature>,
    add<ClearanceFeature>,
    add<MeasureFeature>,
    add<SectionFeature>,
    addStatistics,
    add<PartsFeature>,
    add<ExportFeature>,
    add<AssignmentFeature>,
    addSearch,
};

/// What one feature finds out and another one lists.
void connectMessages(const FeatureContext& context) {
    QObject::connect(context.window.findChild<ClearanceFeature*>(), &ClearanceFeature::rulesListed,
                     context.window.findChild<MessageModel*>(), &MessageModel::setRules);
}

}  // namespace

void addFeatures(FeatureContext& context) {
    for (const auto feature : kFeatures) {
        feature(context);
    }
    connectMessages(context);
}

}  // namespace ui
