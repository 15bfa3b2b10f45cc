# SPDX-License-Identifier: MIT
"""Conditions that no input fails alone, each with the reason; see conditions.py."""
IMPLIED = {
    ('src/stored/stored_planes.cpp', '!std::visit([&](const auto& proof) { return check(cone, proof); }, outcome)'):
        'find_recession() proves its answers, so no input fails this: it refuses a defect of the solver.',
}
