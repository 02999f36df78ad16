"""Time the stages of a long command, and show the times at its end."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field


@dataclass
class Stages:
    """The stages so far, with their seconds. The first is the set-up that make did before."""

    started: float
    seconds: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.seconds["set-up"] = max(0.0, time.time() - self.started)

    @contextmanager
    def stage(self, name: str, headline: str) -> Iterator[None]:
        """Announce a stage, then take its time, even when it fails."""
        print(f"\n━━ {name}: {headline}", flush=True)
        begin = time.time()
        try:
            yield
        finally:
            self.seconds[name] = time.time() - begin

    def table(self) -> str:
        rows = [*self.seconds.items(), ("together", sum(self.seconds.values()))]
        return "\n".join(f"  {name:<12}{seconds:7.1f} s" for name, seconds in rows)
