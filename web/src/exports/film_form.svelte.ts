/** Pixels, and frames a second. */
export interface FilmForm {
  width: number;
  height: number;
  rate: number;
}
export const film_sizes = [
  {width: 640, height: 480},
  {width: 1280, height: 720},
  {width: 1920, height: 1080},
] as const;
export const film_rates = [24, 30, 60] as const;

/** As films are made until another form is chosen. */
class FilmChoice {
  size = $state.raw<(typeof film_sizes)[number]>(film_sizes[1]);
  rate = $state.raw<(typeof film_rates)[number]>(30);

  get form(): FilmForm {
    return {...this.size, rate: this.rate};
  }
}
export const film_choice = new FilmChoice();
