#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""An insertion as an environment for reinforcement learning, by Gymnasium's protocol, and two policies in it: environment.py [FILE.png]

Nothing of Gymnasium is imported: its wrappers and most libraries need reset(), step() and the two spaces only.
"""

import copy
import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph


class Box:
    """Numbers in an interval each, as gymnasium.spaces.Box."""

    def __init__(self, low, high):
        self.low, self.high = np.asarray(low, np.float32), np.asarray(high, np.float32)
        self.shape, self.dtype = self.low.shape, self.low.dtype
        self.generator = np.random.default_rng()

    def seed(self, seed=None):
        self.generator = np.random.default_rng(seed)

    def sample(self):
        return self.generator.uniform(self.low, self.high).astype(self.dtype)

    def contains(self, values):
        values = np.asarray(values)
        return values.shape == self.shape and bool(np.all((self.low <= values) & (values <= self.high)))


class InsertionEnvironment:
    """Action: speed [mm/s] for a fifth of a second. Observation: depth [mm], tip angle [deg], axial force [mN], highest axial force
    so far [mN]. Reward: millimeters of new depth less a price for each millinewton by which the highest force rises. An episode
    ends as the insertion does, and is truncated after a minute. Two resets are equal but for the approach, which reset(seed)
    draws if `spread_deg` is not 0."""

    metadata = {"render_modes": []}
    render_mode = None

    def __init__(self, scenario="surgery-flex28", overrides=None, spread_deg=0.0, price_per_mN=0.05):
        self.scenario, self.overrides = scenario, {"nodes": 50, "dt_ms": 5, "stop_travel_mm": 27, **(overrides or {})}
        self.spread_deg, self.price_per_mN = spread_deg, price_per_mN
        self.action_space = Box([-1.0], [2.0])
        self.observation_space = Box([-5.0, 0.0, -2000.0, 0.0], [40.0, 1000.0, 2000.0, 2000.0])
        self.insertion, self.peak_mN, self.generator = None, 0.0, np.random.default_rng()

    @property
    def unwrapped(self):
        return self

    def reset(self, *, seed=None, options=None):
        if seed is not None:
            self.generator = np.random.default_rng(seed)
        if self.insertion is None or self.spread_deg > 0.0:
            tilt_deg, turn_deg = self.spread_deg * self.generator.standard_normal(2).clip(-3.0, 3.0)
            approach = {"approach_tilt_deg": tilt_deg, "approach_turn_deg": turn_deg} if self.spread_deg > 0.0 else {}
            self.insertion = perilymph.Insertion(self.scenario, {**self.overrides, **approach})
        self.insertion.reset()
        self.peak_mN = 0.0
        return self._observation(self.insertion.reading), {}

    def step(self, action):
        speed_mm_s = float(np.clip(action, self.action_space.low, self.action_space.high)[0])
        before_mm, before_mN = self.insertion.reading.depth_mm, self.peak_mN
        now = self.insertion.advance(speed_mm_s, ticks=max(1, round(0.2 / self.insertion.time_step_s)))
        self.peak_mN = max(self.peak_mN, 1e3 * now.force_axial_N)
        reward = now.depth_mm - before_mm - self.price_per_mN * (self.peak_mN - before_mN)
        truncated = now.time_s > 60.0 and not self.insertion.has_ended
        return self._observation(now), reward, self.insertion.has_ended, truncated, {"end": now.end, "events": now.events}

    def render(self):
        return None

    def close(self):
        self.insertion = None

    def _observation(self, now):
        return np.array([now.depth_mm, now.tip_angle_deg, 1e3 * now.force_axial_N, self.peak_mN], np.float32)


def steady(environment, observation):
    return np.array([0.66])


def looking_ahead(environment, observation):
    """Tries two speeds in copies of the insertion and takes the better one; 0 where each costs more than it gives."""
    def gain(speed_mm_s):
        now = copy.copy(environment.insertion).advance(speed_mm_s, ticks=80)
        rise_mN = max(0.0, 1e3 * now.force_axial_N - observation[3])
        return now.depth_mm - observation[0] - environment.price_per_mN * rise_mN
    best = max((0.3, 0.66), key=gain)
    return np.array([best if gain(best) > 0.0 else 0.0])


def episode(environment, policy):
    observation, _ = environment.reset(seed=1)
    seen, total, is_over, info = [observation], 0.0, False, {}
    while not is_over:
        observation, reward, terminated, truncated, info = environment.step(policy(environment, observation))
        seen.append(observation)
        total += reward
        is_over = terminated or truncated
    return np.array(seen), total, info["end"]


def main(file="environment.png"):
    environment = InsertionEnvironment()
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    for name, policy in (("0.66 mm/s", steady), ("looks 0.4 s ahead", looking_ahead)):
        seen, total, end = episode(environment, policy)
        depth_mm, angle_deg, force_mN, peak_mN = seen.T
        axes.plot(depth_mm, force_mN, label=f"{name}: return {total:.1f}")
        print(f"{name:26} return {total:6.2f}  {depth_mm[-1]:5.2f} mm  tip {angle_deg[-1]:4.0f} deg  peak {peak_mN[-1]:6.1f} mN  {end}")
    axes.set(xlabel="insertion depth, mm", ylabel="axial insertion force, mN", xlim=(0, None), ylim=(0, None))
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
