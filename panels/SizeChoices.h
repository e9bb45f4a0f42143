// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeSize.h"
#include "panels/Bar.h"

#include <array>

namespace espalier {

/// Offers the sizes of a new tree, on a page that is still blank.
class SizeChoices : public Bar {
    Q_OBJECT

public:
    explicit SizeChoices(QWidget* parent = nullptr);

    /// Marks the size that the page has.
    void setSize(TreeSize size);

Q_SIGNALS:
    void sizeAsked(espalier::TreeSize size);

private:
    std::array<BarButton*, kTreeSizeCount> m_buttons{};
};

} // namespace espalier
