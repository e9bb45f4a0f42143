// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"
#include "panels/ParameterEditor.h"
#include "panels/ParameterTexts.h"

#include <vector>

class QComboBox;
class QHBoxLayout;
class QToolButton;

namespace espalier {

class Diagram;
class ParameterRow;
class Sideways;
class TropismDiagram;
class ValueField;

/// The choice of the growth model, and the parameters of the model in force. TreeSketch's are drawings with
/// handles to drag (§3.4, figure 16): cards side by side, one with the schematic tree; sliders and switches;
/// and on demand its other parameters. The vigour model's are rows, and a choice of species. Contents that
/// are too wide for the window scroll sideways.
class ArchitecturePanel : public Bar {
    Q_OBJECT

public:
    explicit ArchitecturePanel(TreeDocument& document, QWidget* parent = nullptr);

    /// Sets the size for a workspace of @p room px: the cards are larger where there is more room.
    void fit(const QSize& room);

    TropismDiagram& schematic() const { return *m_schematic; }
    const std::vector<Diagram*>& diagrams() const { return m_diagrams; }
    /// The controls of a parameter, or null if it has none of that kind.
    ParameterRow* row(std::string_view key) const;
    ValueField* field(std::string_view key) const;

    /// Shows the species whose vigour parameters are in force; the first item means that they are no
    /// species'.
    QComboBox& species() const { return *m_species; }
    bool isMoreShown() const;
    void showMore(bool shown);

Q_SIGNALS:
    /// The panel's best width has changed: call fit() again.
    void sizeWanted();

private:
    QWidget* makeCard(const ParameterSection& section, QWidget* parent);
    QWidget* makeColumn(const ParameterSection& section, QWidget* parent);
    Diagram* makeDiagram(const ParameterSection& section, QWidget* parent);
    void addSection(const ParameterSection& section, QHBoxLayout& line);
    void addMoreButton(QWidget& column);
    void makeSpecies(QWidget& column);
    void chooseSpecies(int item);
    void setSpacing(int spacing, int margin);
    void follow();

    ParameterEditor m_editor;
    TropismDiagram* m_schematic = nullptr;
    std::vector<Diagram*> m_diagrams;
    std::vector<QWidget*> m_cards;
    std::vector<ValueField*> m_fields;
    std::vector<ParameterRow*> m_rows;
    QToolButton* m_moreButton;
    QWidget* m_treeSketch; ///< The controls of TreeSketch's model
    QWidget* m_more;       ///< Those that show on demand
    QWidget* m_vigour;     ///< The controls of the vigour model
    QComboBox* m_species = nullptr;
    Sideways* m_sideways;
};

} // namespace espalier
