"""Score distillation on a batch of latents: SDS, and two of its successors behind one function.

    sds  w(t) (ε̂_φ(z_t; y, t) - ε)         Fantasia3D Eqs. 1, 5 and 9
    csd  w(t) s (ε(y) - ε(∅))              Yu et al. 2024, "Text-to-3D with classifier score
                                           distillation"; the term of SDS that the scale s weighs
    sdi  w(t) (ε̂_φ(z_t; y, t) - κ)         Lukoianov et al. 2024, "Score distillation via
                                           reparametrized DDIM"; κ is found by inverting DDIM

w(t) is that of Fantasia3D's "Implementation Details" in all three.
Notation: sigma is the paper's variance-preserving noise level, ``sigma**2 = 1 - alpha_bar``.
It is not the EDM / k-diffusion sigma, which is ``sqrt((1 - alpha_bar) / alpha_bar)``.
"""

from collections.abc import Iterator
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.config import Distillation, Weighting
from core.errors import UserError
from core.guidance.guidance import Predictions, PromptedGuidance, Views


class NotFiniteError(UserError):
    """NaN or infinity came out of the guidance, or went in."""


class Method(NamedTuple):
    """How a score becomes a gradient: one of the three at the file's head."""

    name: Distillation = "sds"
    negative: Float[Tensor, " b"] | None = None  # csd: weight of the negative prompt, by view
    inversion_steps: int = 10  # sdi: predictions for one noise


SDS = Method()


def add_noise(
    z: Float[Tensor, "b 4 h w"], eps: Float[Tensor, "b 4 h w"], alpha_bar: Float[Tensor, " b"]
) -> Float[Tensor, "b 4 h w"]:
    """Diffuse ``z``: z_t = sqrt(alpha_bar) z + sigma eps."""
    alpha_bar = alpha_bar[:, None, None, None]
    return alpha_bar.sqrt() * z + (1 - alpha_bar).sqrt() * eps


def eps_from_v(
    v: Float[Tensor, "b 4 h w"], z_t: Float[Tensor, "b 4 h w"], alpha_bar: Float[Tensor, " b"]
) -> Float[Tensor, "b 4 h w"]:
    """The noise that a v-prediction implies: eps = sqrt(alpha_bar) v + sigma z_t.

    v = sqrt(alpha_bar) eps - sigma z. Source: Salimans and Ho 2022, appendix D.
    """
    alpha_bar = alpha_bar[:, None, None, None]
    return alpha_bar.sqrt() * v + (1 - alpha_bar).sqrt() * z_t


def guide(
    eps_cond: Float[Tensor, "b 4 h w"], eps_uncond: Float[Tensor, "b 4 h w"], scale: float
) -> Float[Tensor, "b 4 h w"]:
    """Classifier-free guidance: ``eps_uncond + scale * (eps_cond - eps_uncond)``.

    ``scale = 1`` is no guidance. DreamFusion counts from the conditional side instead, so its
    omega is ``scale - 1``.
    """
    return eps_uncond + scale * (eps_cond - eps_uncond)


def perp_neg(
    direction: Float[Tensor, "b 4 h w"], negative: Float[Tensor, "b 4 h w"]
) -> Float[Tensor, "b 4 h w"]:
    """The part of ``negative`` that is perpendicular to ``direction``, picture by picture.

    Subtracting it steers away from the negative words without weakening the positive ones.
    Both are differences to the unconditional prediction. Source: Armandpour et al. 2023, Eq. 6.
    """
    dot = (negative * direction).sum((1, 2, 3), keepdim=True)
    # The smallest positive float keeps 0 / 0 at 0: without a direction all of it is perpendicular.
    norm2 = direction.square().sum((1, 2, 3), keepdim=True).clamp(min=1e-30)
    return negative - dot / norm2 * direction


def guided(predictions: Predictions, scale: float) -> Float[Tensor, "b 4 h w"]:
    """ε̂ of all predictions together: classifier-free guidance, then Perp-Neg.

    Perp-Neg steers away from each opposing prediction as far as that is perpendicular to the
    prompt's own direction (Armandpour et al. 2023, Eq. 8), with the same guidance scale.
    """
    if predictions.uncond is None:
        return predictions.cond
    # At scale 1 too: u + (c - u) differs from c in its last bits, and a run repeats to the bit.
    eps_hat = guide(predictions.cond, predictions.uncond, scale)
    for part in opposed(predictions):
        eps_hat = eps_hat - scale * part
    return eps_hat


def opposed(predictions: Predictions) -> Iterator[Float[Tensor, "b 4 h w"]]:
    """Perp-Neg's part of each opposing prediction, weighted by the view's weight."""
    cond, uncond, opposing, weights, _ = predictions
    if uncond is None or opposing is None or weights is None:
        return
    for eps_view, view_weight in zip(opposing, weights, strict=True):
        # Only the perpendicular part: the prompt seen from another side is mostly the prompt
        # itself.
        yield view_weight[:, None, None, None] * perp_neg(cond - uncond, eps_view - uncond)


def classifier_score(
    predictions: Predictions, negative: Float[Tensor, " b"] | None = None
) -> Float[Tensor, "b 4 h w"]:
    """ε(y) - ε(∅) - ω (ε(neg) - ε(∅)): CSD's direction, with ``negative`` for ω.

    At ω = ½ it is ε(y) - ½ ε(neg) - ½ ε(∅) (Yu et al. 2024, with ω1 = 1). Without an unconditional
    prediction the words change nothing, and it is 0.
    """
    if predictions.uncond is None:
        return torch.zeros_like(predictions.cond)
    score = predictions.cond - predictions.uncond
    if negative is not None and predictions.negative is not None:
        away = predictions.negative - predictions.uncond
        score = score - negative.to(score)[:, None, None, None] * away
    for part in opposed(predictions):
        score = score - part
    return score


def predict_eps(
    guidance: PromptedGuidance,
    z_t: Float[Tensor, "b 4 s s"],
    t: Int[Tensor, " b"],
    views: Views,
    scale: float,
) -> Float[Tensor, "b 4 s s"]:
    """ε̂_φ(z_t; y, t) with classifier-free guidance; ``scale`` 1 is none. Without gradient."""
    return guided(guidance.predict(z_t, t, views, cond_only=scale == 1), scale)


@torch.no_grad()
def inverted_noise(
    guidance: PromptedGuidance,
    z: Float[Tensor, "b 4 s s"],
    t: Int[Tensor, " b"],
    views: Views,
    scale: float,
    steps: int,
) -> Float[Tensor, "b 4 s s"]:
    """κ, the noise at which DDIM would arrive when run backwards from the clean ``z`` to t.

    Lukoianov et al. 2024, §5: SDS then follows one trajectory of DDIM instead of the mean over all
    noises. ``scale`` is that of the inversion: the authors found minus the guidance's.
    """
    alpha_bar, z_t = guidance.alpha_bar.to(z), z
    a, b = torch.ones_like(z[:, :1, :1, :1]), torch.ones_like(z[:, :1, :1, :1])
    for step in range(steps):
        eps = predict_eps(guidance, z_t, t * step // steps, views, scale)
        b = alpha_bar[t * (step + 1) // steps][:, None, None, None]
        # DDIM without new noise (Song et al. 2021, Eq. 12), towards the noisier side.
        clean = (z_t - (1 - a).sqrt() * eps) / a.sqrt()
        z_t, a = b.sqrt() * clean + (1 - b).sqrt() * eps, b
    return (z_t - b.sqrt() * z) / (1 - b).sqrt()


def weight(alpha_bar: Float[Tensor, " b"], kind: Weighting) -> Float[Tensor, " b"]:
    """The SDS weight w(t).

    Args:
        alpha_bar: cumulative product of alphas at t, in (0, 1).
        kind: ``sigma2`` for early geometry, ``sigma2_sqrt`` = sigma^2 sqrt(1 - sigma^2) for late
            geometry and early appearance, ``inv_sigma2`` = 1 / sigma^2 for late appearance.
    """
    sigma2 = 1 - alpha_bar
    if kind == "sigma2":
        return sigma2
    if kind == "sigma2_sqrt":
        return sigma2 * alpha_bar.sqrt()
    return 1 / sigma2


def sample_t(
    n: int, low: float, high: float, steps: int, generator: torch.Generator
) -> Int[Tensor, " {n}"]:
    """``n`` timesteps, uniform over the whole numbers from low * steps to high * steps.

    Args:
        low, high: fractions of the schedule, 0 <= low <= high <= 1; anneal them with ``anneal``.
        steps: length of the schedule, ``len(guidance.alpha_bar)``.
    """
    if not 0 <= low <= high <= 1:
        raise UserError(
            f"Timesteps from {low:g} to {high:g} of the schedule are an empty range.",
            "Give two fractions with 0 <= low <= high <= 1.",
        )
    # A fraction of 1 is the last index, not the one behind it.
    first, last = (min(round(fraction * steps), steps - 1) for fraction in (low, high))
    return torch.randint(first, last + 1, (n,), generator=generator, device=generator.device)


def anneal(start: float, end: float, progress: float) -> float:
    """Linear from ``start`` at progress 0 to ``end`` at progress 1, constant outside."""
    return start + (end - start) * min(max(progress, 0.0), 1.0)


def cap_rms(grad: Float[Tensor, "b 4 h w"], cap: float) -> Float[Tensor, "b 4 h w"]:
    """Scale each view's gradient down to a root mean square of at most ``cap``.

    Per view, so that a batch split for gradient accumulation gives what the whole batch gives.
    """
    rms = grad.square().mean((1, 2, 3), keepdim=True).sqrt()
    # Below the cap the factor is 1: no gradient is scaled up.
    return grad * (cap / rms.clamp(min=cap))


def sds_grad(
    guidance: PromptedGuidance,
    z: Float[Tensor, "b 4 s s"],
    views: Views,
    t: Int[Tensor, " b"],
    eps: Float[Tensor, "b 4 s s"],
    weighting: Weighting,
    guidance_scale: float,
    *,
    cap: float | None = None,
    method: Method = SDS,
) -> Float[Tensor, "b 4 s s"]:
    """w(t) (ε̂_φ(z_t; y, t) - ε), the SDS gradient in the latent (Eqs. 1, 5, 9).

    Args:
        z: clean latents; only their values are used.
        t: indices into ``guidance.alpha_bar``.
        eps: standard normal noise, drawn by the caller; sdi finds its own.
        cap: the largest root mean square of a view's gradient (``cap_rms``). None: as it is.
        method: SDS, or one of the others at the file's head in its place.

    Raises:
        NotFiniteError: the latents or the guidance's answer hold NaN or infinity.
    """
    # The network's Jacobian is left out (Eq. 1): nothing behind the latent needs a graph.
    z = z.detach()
    alpha_bar = guidance.alpha_bar.to(z)[t.to(z.device)]
    if method.name == "sdi":
        eps = inverted_noise(guidance, z, t, views, -guidance_scale, method.inversion_steps)
    with torch.no_grad():
        z_t = add_noise(z, eps, alpha_bar)
        if method.name == "csd":
            # Apart at weight 0 too: else the negative prompt takes the place of no words.
            predictions = guidance.predict(z_t, t, views, apart=True)
            score = guidance_scale * classifier_score(predictions, method.negative)
        else:
            score = predict_eps(guidance, z_t, t, views, guidance_scale) - eps
    # Checked on both sides of the network, so that the message names the place of the fault; and
    # together, so that a GPU is waited for once.
    if not bool(z.isfinite().all() & score.isfinite().all()):
        _require_finite(z, t, "The picture that goes to the guidance")
        _require_finite(score, t, "The guidance's noise prediction")
    # Capped after the weighting: the bound is on what reaches the latent.
    grad = weight(alpha_bar, weighting)[:, None, None, None] * score
    return grad if cap is None else cap_rms(grad, cap)


def sds_loss(z: Float[Tensor, "b 4 h w"], grad: Float[Tensor, "b 4 h w"]) -> Float[Tensor, ""]:
    """A scalar whose gradient in ``z`` is exactly ``grad``.

    The U-Net's Jacobian is left out on purpose (Eq. 1), so ``grad`` is a constant here. The value
    is half the squared gradient's sum: it shows the pull that is left, not a loss that must fall.
    """
    grad = grad.detach()
    # Not 0.5 * (z - target)**2: the rounding of z - (z - grad) would reach the gradient.
    return 0.5 * grad.square().sum() + (grad * (z - z.detach())).sum()


def _require_finite(x: Tensor, t: Tensor, what: str) -> None:
    finite = x.isfinite()
    if bool(finite.all()):
        return
    bad = (~finite.flatten(1).all(1)).nonzero()[:, 0].tolist()
    raise NotFiniteError(
        f"{what} is not finite in {len(bad)} of {len(x)} views (t = {t.cpu()[bad].tolist()}).",
        "Lower the learning rate or the guidance scale; in 16-bit, use 32-bit precision.",
    )
