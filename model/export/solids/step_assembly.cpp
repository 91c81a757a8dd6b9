#include "model/export/solids/step_assembly.h"

#include <algorithm>

namespace model {

namespace {

/// Styled solids in one list; readers take any length, people and diff tools do not.
constexpr std::size_t kStylesInList = 1000;

}  // namespace

StepAssembly::StepAssembly(StepText& text, StepId origin) : m_text(text), m_origin(origin) {
    const StepId application = m_text.add("APPLICATION_CONTEXT('managed model based 3d engineering')");
    m_text.add(
        "APPLICATION_PROTOCOL_DEFINITION('international standard','ap242_managed_model_based_3d_engineering',2014,",
        application, ")");
    m_productContext = m_text.add("PRODUCT_CONTEXT('',", application, ",'mechanical')");
    m_definitionContext = m_text.add("PRODUCT_DEFINITION_CONTEXT('part definition',", application, ",'design')");
    const StepId length = m_text.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    const StepId angle = m_text.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const StepId solidAngle = m_text.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const StepId uncertainty =
        m_text.add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),", length, ",'distance_accuracy_value','')");
    m_context = m_text.add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((", uncertainty,
                           "))GLOBAL_UNIT_ASSIGNED_CONTEXT((", length, ",", angle, ",", solidAngle,
                           "))REPRESENTATION_CONTEXT('',''))");
}

StepProduct StepAssembly::addProduct(std::string_view name, std::string_view kind, std::span<const StepId> items) {
    const std::string word = stepString(name);
    const StepId product = m_text.add("PRODUCT(", word, ",", word, ",'',(", m_productContext, "))");
    m_text.add("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(", product, "))");
    const StepId formation = m_text.add("PRODUCT_DEFINITION_FORMATION('','',", product, ")");
    StepProduct made;
    made.definition = m_text.add("PRODUCT_DEFINITION('design','',", formation, ",", m_definitionContext, ")");
    const StepId shape = m_text.add("PRODUCT_DEFINITION_SHAPE('','',", made.definition, ")");
    made.representation = m_text.add(kind, "('',", items, ",", m_context, ")");
    m_text.add("SHAPE_DEFINITION_REPRESENTATION(", shape, ",", made.representation, ")");
    return made;
}

StepProduct StepAssembly::addPart(std::string_view name, std::span<const StepId> items) {
    std::vector<StepId> all{m_origin};
    all.insert(all.end(), items.begin(), items.end());
    return addProduct(name, "ADVANCED_BREP_SHAPE_REPRESENTATION", all);
}

StepProduct StepAssembly::addGroup(std::string_view name) {
    const StepId items[] = {m_origin};
    return addProduct(name, "SHAPE_REPRESENTATION", items);
}

void StepAssembly::place(const StepProduct& child, const StepProduct& parent, std::string_view name, StepId placement) {
    const std::string number = "'" + std::to_string(++m_placed) + "'";
    const StepId usage = m_text.add("NEXT_ASSEMBLY_USAGE_OCCURRENCE(", number, ",", stepString(name), ",'',",
                                    parent.definition, ",", child.definition, ",$)");
    const StepId shape = m_text.add("PRODUCT_DEFINITION_SHAPE('','',", usage, ")");
    const StepId move = m_text.add("ITEM_DEFINED_TRANSFORMATION('','',", m_origin, ",", placement, ")");
    const StepId relation =
        m_text.add("(REPRESENTATION_RELATIONSHIP('','',", child.representation, ",", parent.representation,
                   ")REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(", move, ")SHAPE_REPRESENTATION_RELATIONSHIP())");
    m_text.add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(", relation, ",", shape, ")");
}

StepId StepAssembly::addShape(std::span<const StepId> solids) {
    std::vector<StepId> all{m_origin};
    all.insert(all.end(), solids.begin(), solids.end());
    const StepId representation = m_text.add("ADVANCED_BREP_SHAPE_REPRESENTATION('',", all, ",", m_context, ")");
    return m_text.add("REPRESENTATION_MAP(", m_origin, ",", representation, ")");
}

StepId StepAssembly::addCopy(StepId shape, StepId placement) {
    return m_text.add("MAPPED_ITEM('',", shape, ",", placement, ")");
}

StepId StepAssembly::styleOf(const StepColour& colour) {
    const auto found = std::ranges::find(m_styles, colour, &std::pair<StepColour, StepId>::first);
    if (found != m_styles.end()) {
        return found->second;
    }
    const auto part = [&](unsigned shift) { return StepText::Ratio{(colour.rgb >> shift & 255U) / 255.0}; };
    const StepId rgb = m_text.add("COLOUR_RGB('',", part(16), ",", part(8), ",", part(0), ")");
    const StepId fill = m_text.add("FILL_AREA_STYLE_COLOUR('',", rgb, ")");
    const StepId area = m_text.add("FILL_AREA_STYLE('',(", fill, "))");
    std::vector<StepId> sides{m_text.add("SURFACE_STYLE_FILL_AREA(", area, ")")};
    if (colour.opacity < 1.0) {
        const StepId clear = m_text.add("SURFACE_STYLE_TRANSPARENT(", StepText::Ratio{1.0 - colour.opacity}, ")");
        sides.push_back(m_text.add("SURFACE_STYLE_RENDERING_WITH_PROPERTIES($,", rgb, ",(", clear, "))"));
    }
    const StepId side = m_text.add("SURFACE_SIDE_STYLE('',", sides, ")");
    const StepId usage = m_text.add("SURFACE_STYLE_USAGE(.BOTH.,", side, ")");
    const StepId style = m_text.add("PRESENTATION_STYLE_ASSIGNMENT((", usage, "))");
    m_styles.emplace_back(colour, style);
    return style;
}

void StepAssembly::colour(StepId solid, const StepColour& colour) {
    const StepId style = styleOf(colour);
    m_styled.push_back(m_text.add("STYLED_ITEM('',(", style, "),", solid, ")"));
    if (m_styled.size() >= kStylesInList) {
        flushStyles();
    }
}

void StepAssembly::flushStyles() {
    if (!m_styled.empty()) {
        m_text.add("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',", m_styled, ",", m_context, ")");
        m_styled.clear();
    }
}

void StepAssembly::finish() {
    flushStyles();
}

std::string stepHeader(std::string_view name, std::string_view time, std::string_view program) {
    const std::string word = stepString(name);
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('printed circuit board'),'2;1');\nFILE_NAME(" + word + ",'" +
           std::string(time) + "',(''),('')," + stepString(program) + "," + stepString(program) +
           ",'');\nFILE_SCHEMA(('AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 "
           "}'));\nENDSEC;\nDATA;\n";
}

std::string_view stepFooter() {
    return "ENDSEC;\nEND-ISO-10303-21;\n";
}

}  // namespace model
