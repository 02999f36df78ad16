"""Settings of the property tests.

``pytest`` tries the same examples each time. ``pytest --hypothesis-profile=search`` looks for new ones, and
for the smallest that fails.
"""

from hypothesis import HealthCheck, Phase, settings

COMMON = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow], "database": None}

settings.register_profile(
    "quick", max_examples=30, derandomize=True, phases=[Phase.explicit, Phase.generate], **COMMON
)
settings.register_profile("search", max_examples=1000, derandomize=False, phases=list(Phase), **COMMON)
settings.load_profile("quick")
